#include "felt/devices/simulated/stylus_presets.h"

#include <array>

namespace felt {
namespace {

constexpr double kOverlapMm = 10.0;

// A workspace of this size, as the header places it.
constexpr Capabilities with_workspace(Vec3 size_mm, Capabilities device) {
  device.workspace_min = {-kOverlapMm, -kOverlapMm, -0.5 * size_mm.z};
  device.workspace_max = device.workspace_min + size_mm;
  return device;
}

constexpr Vec3 kBigSheetMm{2000.0, 2000.0, 200.0};

constexpr std::array<StylusPreset, 9> kPresets{{
    {.name = "worst",
     .label = "Worst case: light, frictionless, coarse",
     .source = "specification section 0; forces as the touch",
     .mechanics = {.mass_kg = 0.045, .weight_n = 0.1},
     .capabilities = with_workspace({160, 120, 70}, {.max_force_n = 3.3,
                                                     .continuous_force_n = 0.88,
                                                     .advised_force_n = 3.0,
                                                     .max_stiffness_n_per_m = 1000.0,
                                                     .max_damping_n_s_per_m = 5.0,
                                                     .position_step_mm = 0.03})},
    {.name = "touch",
     .label = "3D Systems Touch (Phantom Omni)",
     .source = "forces: CHAI3D's table, maker's sheet; mass, friction, steps, workspace: estimate",
     .mechanics = {.mass_kg = 0.045, .friction_n = 0.26, .weight_n = 0.1},
     .capabilities = with_workspace({160, 120, 70}, {.max_force_n = 3.3,
                                                     .continuous_force_n = 0.88,
                                                     .advised_force_n = 2.5,
                                                     .max_stiffness_n_per_m = 400.0,
                                                     .max_damping_n_s_per_m = 4.0,
                                                     .position_step_mm = 0.055})},
    {.name = "touch-x",
     .label = "3D Systems Touch X (Phantom Desktop)",
     .source = "forces: CHAI3D's table; the rest: estimate",
     .mechanics = {.mass_kg = 0.045, .friction_n = 0.06, .weight_n = 0.1},
     .capabilities = with_workspace({160, 120, 120}, {.max_force_n = 7.9,
                                                      .continuous_force_n = 1.75,
                                                      .advised_force_n = 5.0,
                                                      .max_stiffness_n_per_m = 1000.0,
                                                      .max_damping_n_s_per_m = 5.0,
                                                      .position_step_mm = 0.023})},
    {.name = "premium",
     .label = "Phantom Premium 1.5",
     .source = "forces: CHAI3D's table; steps: the 2002 paper; mass, friction: estimate",
     .mechanics = {.mass_kg = 0.075, .friction_n = 0.04, .weight_n = 0.05},
     .capabilities = with_workspace({381, 267, 191}, {.max_force_n = 8.5,
                                                      .continuous_force_n = 1.4,
                                                      .advised_force_n = 5.0,
                                                      .max_stiffness_n_per_m = 800.0,
                                                      .max_damping_n_s_per_m = 5.0,
                                                      .position_step_mm = 0.03})},
    {.name = "falcon",
     .label = "Novint Falcon",
     .source = "forces, workspace: CHAI3D's table; mass, friction, steps, continuous: estimate",
     .mechanics = {.mass_kg = 0.15, .friction_n = 0.4, .viscous_n_s_per_m = 0.5, .weight_n = 0.3},
     .capabilities = with_workspace({80, 80, 80}, {.max_force_n = 8.0,
                                                   .continuous_force_n = 2.5,
                                                   .advised_force_n = 6.0,
                                                   .max_stiffness_n_per_m = 3000.0,
                                                   .max_damping_n_s_per_m = 20.0,
                                                   .position_step_mm = 0.06})},
    {.name = "omega",
     .label = "Force Dimension omega.3",
     .source = "forces: CHAI3D's table; steps, workspace, mass, friction: estimate",
     .mechanics = {.mass_kg = 0.3, .friction_n = 0.05},
     .capabilities = with_workspace({160, 160, 110}, {.max_force_n = 12.0,
                                                      .continuous_force_n = 12.0,
                                                      .advised_force_n = 6.0,
                                                      .max_stiffness_n_per_m = 5000.0,
                                                      .max_damping_n_s_per_m = 30.0,
                                                      .position_step_mm = 0.01,
                                                      .period_ns = 250'000})},
    {.name = "inverse3",
     .label = "Haply Inverse3",
     .source = "stiffness: the maker's tutorials; the rest: estimate",
     .mechanics = {.mass_kg = 0.12, .friction_n = 0.05, .weight_n = 0.1},
     .capabilities = with_workspace({115, 115, 115}, {.max_force_n = 10.0,
                                                      .continuous_force_n = 3.0,
                                                      .advised_force_n = 3.0,
                                                      .max_stiffness_n_per_m = 1000.0,
                                                      .max_damping_n_s_per_m = 5.0,
                                                      .position_step_mm = 0.02})},
    {.name = "mouse",
     .label = "Mouse: no force, no pressure",
     .source = "no figures needed",
     .mechanics = {},
     .capabilities = with_workspace(kBigSheetMm, {.sensed_axes = 2, .actuated_axes = 0})},
    {.name = "tablet",
     .label = "Tablet: pressure, no force",
     .source = "no figures needed",
     .mechanics = {},
     .capabilities = with_workspace(
         kBigSheetMm, {.sensed_axes = 2, .actuated_axes = 0, .senses_pressure = true})},
}};

}  // namespace

std::span<const StylusPreset> stylus_presets() noexcept {
  return kPresets;
}

const StylusPreset* find_stylus_preset(std::string_view name) noexcept {
  for (const StylusPreset& preset : kPresets) {
    if (preset.name == name) return &preset;
  }
  return nullptr;
}

void center_workspace(Capabilities& device, Point middle_mm) noexcept {
  const Vec3 middle = 0.5 * (device.workspace_min + device.workspace_max);
  const Vec3 shift{middle_mm.x - middle.x, middle_mm.y - middle.y, 0.0};
  device.workspace_min += shift;
  device.workspace_max += shift;
}

}  // namespace felt
