#pragma once

#include <span>
#include <string_view>

namespace felt {

/// A sheet to draw on (specification 5b): the plane's resistance and the friction on it.
struct SurfaceMaterial {
  std::string_view id;  ///< "paper"
  std::string_view label;
  double stiffness_n_per_m = 500.0;
  double damping_n_s_per_m = 2.0;
  double friction = 0.25;  ///< mu of the reference tool, the pencil, on it
  /// Grain: RMS height and wavelength of its height field (specification 5i); 0 = smooth.
  double grain_um = 0.0;
  double grain_mm = 0.0;
};

/// What the pen is made of (specification 5f): its friction on paper.
struct ToolMaterial {
  std::string_view id;  ///< "pencil"
  std::string_view label;
  double friction = 0.25;
  double bristle_n_per_m = 600.0;  ///< stiffness of the friction before it slides
  double bristle_n_s_per_m = 2.0;
  double grain = 1.0;  ///< how much of the surface's grain comes through
};

/// paper, blackboard, felt, glass; the first is the default.
std::span<const SurfaceMaterial> surface_materials() noexcept;
/// pencil, chalk, crayon, felt-tip, eraser; the first is the default.
std::span<const ToolMaterial> tool_materials() noexcept;
/// By id, or null.
const SurfaceMaterial* find_surface(std::string_view id) noexcept;
const ToolMaterial* find_tool_material(std::string_view id) noexcept;

/// Friction coefficient of a pair: mu_tool mu_surface / mu_paper (architecture section 10).
double friction_of(const ToolMaterial& tool, const SurfaceMaterial& surface) noexcept;

}  // namespace felt
