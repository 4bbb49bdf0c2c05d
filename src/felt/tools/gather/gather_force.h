#pragma once

#include <algorithm>

#include "felt/haptics/bricks/drawing_feel.h"
#include "felt/haptics/force_model.h"
#include "felt/tools/feel_id.h"
#include "felt/tools/gather/gather_options.h"
#include "felt/tools/scene.h"

namespace felt {

/// Renders the resistance of a bundle as friction, which gives way as the bundle becomes one line.
///
///   mu = mu0 + min(min(kMaxN, kNPerMm s)/Fn, kMaxFactor)
///
/// with mu the friction coefficient, mu0 that of the surface alone, Fn the force of the plane in
/// this tick, and s the spread: how far the lines ahead of the brush still have to move (rms, mm).
///
/// It is friction for the reasons that RoughFeel gives: friction only dissipates energy, is silent
/// at rest, and needs no further spring. BundleFeel must come between Texture and Friction.
class BundleFeel {
 public:
  static constexpr double kMaxN = 0.5;       ///< maximum additional friction, N
  static constexpr double kNPerMm = 0.5;     ///< additional friction for each mm of spread
  static constexpr double kMaxFactor = 0.6;  ///< so that a light hand is not held fast

  /// `friction` is mu0. If it is 0, nothing is added. `share` scales the effect.
  BundleFeel(double spread_mm, double friction, double share) noexcept
      : more_n_(share * std::clamp(kNPerMm * spread_mm, 0.0, kMaxN)),
        max_factor_(share * kMaxFactor),
        friction_(friction) {}

  Force operator()(const PenSample&, ForceMemory& memory) const noexcept {
    if (memory.normal_force_n > 0.0 && friction_ > 0.0) {
      const double more = std::min(more_n_ / memory.normal_force_n, max_factor_) / friction_;
      memory.friction_factor += more;
      memory.friction_grain += more;
    }
    return {};
  }
  /// Returns zero slopes, because the spring belongs to Friction.
  [[nodiscard]] Slopes slopes() const noexcept { return {}; }

 private:
  double more_n_;
  double max_factor_;
  double friction_;
};

/// Factor on the pencil's friction and grain. It is small because the tool leaves no ink, so that
/// the resistance of the bundle can be told from the friction of the surface.
inline constexpr double kGatherGlide = 0.5;

/// Returns the force model: the surface, and the resistance of a bundle with this spread.
inline ForceModel make_gather_force(const Scene& scene, double spread_mm, double strength) {
  const double glide = kGatherGlide * strength;
  const Medium material = scaled_medium(medium_of(scene, "pencil"), glide, glide);
  const FrictionOptions friction = friction_for(material, scene.surface, scene.device);
  const TextureOptions texture = texture_for(material, scene.surface, scene.device);
  ForceModel model(Compose(
      Plane(plane_for(scene.surface, scene.device)), Texture(surface_grain(scene.surface), texture),
      BundleFeel(spread_mm, friction.coefficient, strength), Friction(friction)));
  model.set_fade_id(FeelId("gather")
                        .with_surface(scene.surface, medium_of(scene, "pencil"))
                        .with(strength)
                        .value());
  return model;
}

}  // namespace felt
