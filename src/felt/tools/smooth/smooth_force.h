#pragma once

#include <algorithm>

#include "felt/haptics/bricks/drawing_feel.h"
#include "felt/haptics/force_model.h"
#include "felt/tools/feel_id.h"
#include "felt/tools/scene.h"

namespace felt {

/// How rough the ink under the iron is, in the hand: friction that grows with the roughness and
/// goes as the ink gets smooth.
///
///   mu = mu0 + min(kMostN/Fn, kMostFactor rho/(rho + kHalfMm))      rho: rms of what is left, mm
///
/// A friction and not a texture: it only ever takes energy, is silent at rest, and its spring is
/// the one the sheet's friction has already. Stands between the texture and the friction; Fn is the
/// plane's push of this tick.
class RoughFeel {
 public:
  static constexpr double kMostN = 0.4;       ///< more than the sheet alone, at any push
  static constexpr double kMostFactor = 0.4;  ///< of the coefficient, for endless roughness
  static constexpr double kHalfMm = 0.1;

  /// `friction` is mu0, more than 0 unless nothing is to be felt; `share` of all this is felt.
  RoughFeel(double roughness_mm, double friction, double share) noexcept
      : more_(share * kMostFactor * roughness_mm / (roughness_mm + kHalfMm)),
        most_n_(share * kMostN),
        friction_(friction) {}

  Force operator()(const PenSample&, ForceMemory& memory) const noexcept {
    if (memory.normal_force_n > 0.0 && friction_ > 0.0) {
      const double more = std::min(more_, most_n_ / memory.normal_force_n);
      memory.friction_factor += more / friction_;
    }
    return {};
  }
  /// That of the friction behind it.
  [[nodiscard]] Slopes slopes() const noexcept { return {}; }

 private:
  double more_;
  double most_n_;
  double friction_;
};

/// What the hand feels: the sheet and the roughness of the ink under the iron.
inline ForceModel make_smooth_force(const Scene& scene, double roughness_mm, double strength) {
  const Medium material = felt_with(medium_of(scene, "pencil"), strength, strength);
  const FrictionOptions friction = friction_for(material, scene.surface, scene.device);
  const TextureOptions texture = texture_for(material, scene.surface, scene.device);
  ForceModel model(Compose(
      Plane(plane_for(scene.surface, scene.device)), Texture(surface_grain(scene.surface), texture),
      RoughFeel(roughness_mm, friction.coefficient, strength), Friction(friction)));
  model.set_fade_id(FeelId("smooth")
                        .with_sheet(scene.surface, medium_of(scene, "pencil"))
                        .with(strength)
                        .value());
  return model;
}

}  // namespace felt
