#include "felt/haptics/material.h"

#include <algorithm>
#include <array>

namespace felt {
namespace {

// Resistance and mu: specification 5b. No measured value of a pencil on paper was found for either
// document, so all coefficients are estimates to be tuned. Grain: RMS height and wavelength, chosen
// such that the steepest place of the field keeps to the bound of specification 5i at 1 kHz
// (material_test.cc, texture_test.cc).
constexpr std::array<SurfaceMaterial, 4> kSurfaces{{
    {.id = "paper",
     .label = "Paper",
     .stiffness_n_per_m = 500.0,
     .damping_n_s_per_m = 2.0,
     .friction = 0.25,
     .grain_um = 2.8,
     .grain_mm = 1.0},
    {.id = "blackboard",
     .label = "Blackboard",
     .stiffness_n_per_m = 800.0,
     .damping_n_s_per_m = 2.0,
     .friction = 0.45,
     .grain_um = 11.0,
     .grain_mm = 2.0},
    {.id = "felt",
     .label = "Felt",
     .stiffness_n_per_m = 300.0,
     .damping_n_s_per_m = 3.0,
     .friction = 0.35,
     .grain_um = 42.0,
     .grain_mm = 4.0},
    {.id = "glass",
     .label = "Glass",
     .stiffness_n_per_m = 800.0,
     .damping_n_s_per_m = 2.0,
     .friction = 0.08},
}};

// Pencil and eraser: specification 5f. Chalk and felt-tip: the mean of the static and the kinetic
// start value of devices.md 10.3, since here both are one. Crayon: between chalk and eraser, a
// guess: wax drags. How much grain comes through is a guess throughout.
constexpr std::array<ToolMaterial, 5> kTools{{
    {.id = "pencil", .label = "Pencil", .friction = 0.25, .grain = 1.0},
    {.id = "chalk", .label = "Chalk", .friction = 0.40, .grain = 1.0},
    {.id = "crayon", .label = "Crayon", .friction = 0.45, .grain = 0.8},
    {.id = "felt-tip", .label = "Felt-tip", .friction = 0.275, .grain = 0.4},
    {.id = "eraser", .label = "Eraser", .friction = 0.60, .grain = 0.2},
}};

template <class Table>
auto find(const Table& table, std::string_view id) noexcept -> decltype(table.data()) {
  const auto at =
      std::find_if(table.begin(), table.end(), [&](const auto& m) { return m.id == id; });
  return at == table.end() ? nullptr : &*at;
}

}  // namespace

std::span<const SurfaceMaterial> surface_materials() noexcept {
  return kSurfaces;
}

std::span<const ToolMaterial> tool_materials() noexcept {
  return kTools;
}

const SurfaceMaterial* find_surface(std::string_view id) noexcept {
  return find(kSurfaces, id);
}

const ToolMaterial* find_tool_material(std::string_view id) noexcept {
  return find(kTools, id);
}

double friction_of(const ToolMaterial& tool, const SurfaceMaterial& surface) noexcept {
  return tool.friction * surface.friction / kSurfaces.front().friction;
}

}  // namespace felt
