#pragma once

#include "felt/geometry/height_field.h"
#include "felt/haptics/force.h"
#include "felt/haptics/force_memory.h"
#include "felt/haptics/pen_sample.h"
#include "felt/material/materials.h"

namespace felt {

/// How a relief is converted to a force.
enum class TextureLaw {
  /// mu(x) = mu0 (1 + 0.8 s(k h(x)/0.8)), s(x) = x/sqrt(1 + x^2). The default.
  kFriction,
  /// F = -Fn grad h (Minsky 1995; docs/design/forces.md#texture).
  kGradient,
};

struct TextureOptions {
  TextureLaw law = TextureLaw::kFriction;
  double strength = 1.0;  ///< 0..1, share of the grain that is felt (Medium::grain)
  /// 0..1, share of the grain that a push of firm_push_n flattens (Medium::wear).
  double wear = 0.0;
  /// The push that flattens the share `wear`, N. If it is 0 or less, every push flattens that
  /// share.
  double firm_push_n = 2.0;
  double friction = 0.25;          ///< mu0 of the Friction that comes after the texture
  double bristle_n_per_m = 600.0;  ///< bristle stiffness of that friction
  double own_friction_n = 0.0;     ///< that of the device (FrictionOptions)
  double period_s = 0.001;         ///< period of the loop; it bounds the strength
};

/// Returns the stiffness that a texture may present at a loop period, N/m: 400 at 1 ms, 800 at 0.2
/// ms (Choi and Tan 2004; docs/design/forces.md#texture), linear in the period in between, and
/// proportional to the rate below 1 kHz.
double texture_stiffness_limit_n_per_m(double period_s) noexcept;

/// Renders the grain of the surface as a force (R48; docs/design/forces.md#texture).
///
/// Why the default is friction and not the gradient: a gradient force pushes the pen even at rest,
/// is a spring (of either sign) that adds to all other springs along the surface, and with the
/// measured Fn has no potential, so that moving the pen in a loop can gain energy. Modulated
/// friction only removes energy (Campion and Hayward 2008) and is silent at rest, because the
/// bristle holds. It also adds no stiffness: while the bristle sticks, the hand feels the stiffness
/// of the bristle and no texture; while it slides, the hand feels the texture and no stiffness of
/// the bristle. The factor k of kFriction is 2 pi/(lambda mu0), so that both laws give the same
/// force, Fn A 2 pi/lambda, for a wave of height A. If this force comes near mu0 Fn, they cannot
/// give the same force, because friction cannot fall below 0. The function s therefore bounds the
/// modulation: it is nowhere steeper than 1 and leaves a fifth of the friction in the deepest
/// valley. So coarse and high relief is felt as broad hills, and a rare peak does not weaken the
/// rest of the texture.
///
/// Bounds. A wave presents the stiffness Fn A (2 pi/lambda)^2. This stiffness stays within
/// texture_stiffness_limit_n_per_m() at every point of the field, not only for its average wave,
/// because it is computed from the field's own maxima. Above a push of 0.6 N the texture does not
/// grow further. A hand draws with 0.3 to 1 N, and a texture that still grew at harder pushes would
/// have to be weaker in that range. If a field is too steep for the limit, its heights are reduced.
///
/// Wear. A soft medium fills the grain when it is pressed: less of the relief is felt as the push
/// grows, just as less of it is seen as the tone grows (relief_left in materials.h). For this, the
/// strength is multiplied by a factor from 1 - wear to 1, which depends only on the push of this
/// tick. So everything above remains true: the factor only reduces the stiffness along the surface;
/// friction still only removes energy; and the push itself never changes the force along the
/// surface faster than friction does anyway: |dF/dFn| of the texture stays within 0.8 mu0.
///
/// Speed. Above the speed lambda/(4T), where lambda is the field's shortest wavelength and T the
/// period of the loop, the loop cannot follow a wave. So the strength is full up to half of
/// lambda/(4T), decreases smoothly above that, and is 0 from lambda/(4T) on.
///
/// A device with friction of its own. The surface's friction is rendered only beyond that of the
/// device (Friction), which would cut off the valleys of a relief, and often all of it. So the part
/// of the relief above its usual valleys, 2 RMS below the mean, is rendered in any case, if
/// it can be felt at all (0.02 N RMS at the push where the texture stops growing). On paper it
/// cannot.
///
/// Place it between the plane and the friction. kFriction acts through memory.friction_factor
/// and memory.friction_grain, and the friction reports the term "texture". The field must outlive
/// the loop; if it is null, the surface is smooth.
class Texture {
 public:
  static constexpr double kMaxCountedN = 0.6;  ///< push above which the texture stops growing, N

  explicit Texture(const HeightField* field = nullptr, const TextureOptions& options = {}) noexcept;

  Force operator()(const PenSample& sample, ForceMemory& memory) const noexcept;
  /// Returns the stiffness of the texture. For kFriction, this is only the part that exceeds the
  /// bristle's stiffness.
  [[nodiscard]] Slopes slopes() const noexcept;
  /// Returns the largest stiffness of the field, as rendered, N/m.
  [[nodiscard]] double stiffness_n_per_m() const noexcept { return stiffness_n_per_m_; }
  /// Returns the share of the texture that remains at a speed: 1 at rest, 0 from lambda/(4T) on; 0
  /// without a field.
  [[nodiscard]] double share_at(double speed_mm_per_s, double period_s) const noexcept;
  /// Returns the push that the texture uses, N: at most kMaxCountedN, reduced by wear.
  [[nodiscard]] double counted_push_n(double push_n) const noexcept;

 private:
  const HeightField* field_;
  TextureLaw law_;
  double friction_;
  double bristle_n_per_m_;
  double wear_;
  double firm_push_n_;
  double valley_ = 0.0;  // depth below the mean from which grain counts; 0: grain is not felt
  double gain_ = 0.0;    // kFriction: k in 1/mm; kGradient: factor of the slope
  double stiffness_n_per_m_ = 0.0;
};

}  // namespace felt
