#pragma once

#include <algorithm>

#include "felt/haptics/bricks/drawing_feel.h"
#include "felt/haptics/force_model.h"
#include "felt/tools/feel_id.h"
#include "felt/tools/scene.h"

namespace felt {

/// Renders the roughness of the ink under the iron as friction, which vanishes as the ink gets
/// smooth.
///
///   mu = mu0 + min(kMaxN/Fn, kMaxFactor rho/(rho + kHalfMm))
///
/// with mu the friction coefficient, mu0 that of the surface alone, Fn the force of the plane in
/// this tick, and rho the roughness, mm.
///
/// The roughness is rendered as friction instead of as a texture, because friction only dissipates
/// energy, is silent at rest, and uses the spring that the friction of the surface already has.
/// RoughFeel must come between Texture and Friction in the chain.
class RoughFeel {
 public:
  static constexpr double kMaxN = 0.4;  ///< maximum additional friction, N
  static constexpr double kMaxFactor =
      0.4;  ///< maximum addition to the coefficient, for infinite roughness
  static constexpr double kHalfMm = 0.1;

  /// `friction` is mu0. If it is 0, nothing is added. `share` scales the effect.
  RoughFeel(double roughness_mm, double friction, double share) noexcept
      : more_(share * kMaxFactor * roughness_mm / (roughness_mm + kHalfMm)),
        max_n_(share * kMaxN),
        friction_(friction) {}

  Force operator()(const PenSample&, ForceMemory& memory) const noexcept {
    if (memory.normal_force_n > 0.0 && friction_ > 0.0) {
      const double more = std::min(more_, max_n_ / memory.normal_force_n);
      memory.friction_factor += more / friction_;
      memory.friction_grain += more / friction_;
    }
    return {};
  }
  /// Returns zero slopes, because the spring belongs to Friction.
  [[nodiscard]] Slopes slopes() const noexcept { return {}; }

 private:
  double more_;
  double max_n_;
  double friction_;
};

/// Returns the force model of the smooth tool: the surface, with friction that depends on the
/// roughness of the ink under the iron.
inline ForceModel make_smooth_force(const Scene& scene, double roughness_mm, double strength) {
  const Medium material = scaled_medium(medium_of(scene, "pencil"), strength, strength);
  const FrictionOptions friction = friction_for(material, scene.surface, scene.device);
  const TextureOptions texture = texture_for(material, scene.surface, scene.device);
  ForceModel model(Compose(
      Plane(plane_for(scene.surface, scene.device)), Texture(surface_grain(scene.surface), texture),
      RoughFeel(roughness_mm, friction.coefficient, strength), Friction(friction)));
  model.set_fade_id(FeelId("smooth")
                        .with_surface(scene.surface, medium_of(scene, "pencil"))
                        .with(strength)
                        .value());
  return model;
}

}  // namespace felt
