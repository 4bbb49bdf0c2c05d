#pragma once

#include "felt/geometry/height_field.h"
#include "felt/haptics/force.h"
#include "felt/haptics/force_memory.h"
#include "felt/haptics/pen_sample.h"
#include "felt/material/materials.h"

namespace felt {

/// How a relief becomes a force.
enum class TextureLaw {
  /// mu(x) = mu0 (1 + 0.8 s(k h(x)/0.8)), s(x) = x/sqrt(1 + x^2): the default.
  kFriction,
  /// F = -Fn grad h (Minsky 1995; specification 5i).
  kGradient,
};

struct TextureOptions {
  TextureLaw law = TextureLaw::kFriction;
  double strength = 1.0;           ///< 0..1, how much of the grain comes through (Medium::grain)
  double wear = 0.0;               ///< 0..1, share that a firm push flattens (Medium::wear)
  double firm_push_n = 2.0;        ///< the push that flattens it so far; not > 0: any push does
  double friction = 0.25;          ///< mu0 of the friction behind it
  double bristle_n_per_m = 600.0;  ///< its stiffness
  double period_s = 0.001;         ///< of the loop: bounds the strength
};

/// Stiffness that a texture may show at a loop period, N/m: 400 at 1 ms, 800 at 0.2 ms (Choi and
/// Tan 2004; specification decision 10), straight in between, in proportion to the rate below 1
/// kHz.
double texture_stiffness_limit_n_per_m(double period_s) noexcept;

/// The grain of the surface in the hand (R48; specification 5i, devices.md 10.4).
///
/// Why friction and not the gradient by default: a gradient force pushes the pen even at rest, is a
/// spring (of either sign) that adds to all others in the sheet, and with the measured Fn it has no
/// potential, so that a loop of the pen can gain energy. A modulated friction only ever takes
/// energy (Campion and Hayward 2008), is silent at rest (the bristle holds), and costs no
/// stiffness: where the bristle sticks its own k is felt and no texture, where it slides the
/// texture and no k. By the same count of force, k = 2 pi/(lambda mu0): both laws give Fn A 2
/// pi/lambda for a wave of height A, until it nears mu0 Fn: friction has no more to give, hence s,
/// which is nowhere steeper than 1 and leaves a fifth of the friction in the deepest hollow. So
/// what is coarse and high is felt as broad hills, and a rare peak does not weaken all the rest.
///
/// Bounds. A wave shows the stiffness Fn A (2 pi/lambda)^2; here it is kept to the limit for the
/// loop's period at every place of the field, not only for its average wave, with what the field
/// knows of itself, and for pushes above 0.6 N the texture stops growing: a hand draws with 0.3 to
/// 1 N, and what is kept for harder pushes would be missing there. A field that is too coarse is
/// felt lower than it is.
///
/// Wear. A soft medium fills the grain when it is pressed: what is left of the relief falls with
/// the push as it does for the eye with the tone (relief_left in materials.h). That is a factor of
/// 1 - wear to 1 which multiplies the strength and depends on this tick's push alone, so nothing of
/// the above changes: it only takes from the stiffness along the sheet at every push; the friction
/// law still only takes energy; and by the push itself the sheet's force never changes faster than
/// friction does anyway: |dF/dFn| of the texture stays within 0.8 mu0.
///
/// Speed. Above v/lambda = 1/(4T) the loop cannot follow a wave. The strength falls smoothly from
/// half of that speed to nothing at it (lambda: the shortest of the field).
///
/// Stand it between the plane and the friction. kFriction speaks through memory.friction_factor,
/// and the friction reports the term "texture". The field must outlive the loop; null is smooth.
class Texture {
 public:
  static constexpr double kMostCountedN = 0.6;  ///< the push from which it no longer grows

  explicit Texture(const HeightField* field = nullptr, const TextureOptions& options = {}) noexcept;

  Force operator()(const PenSample& sample, ForceMemory& memory) const noexcept;
  /// kFriction: what exceeds the bristle. kGradient: all of it.
  [[nodiscard]] Slopes slopes() const noexcept;
  /// The stiffest place of the field, as felt, N/m.
  [[nodiscard]] double stiffness_n_per_m() const noexcept { return stiffness_n_per_m_; }
  /// Share of the texture that is left at a speed: 1 at rest, 0 from shortest lambda/(4T).
  [[nodiscard]] double share_at(double speed_mm_per_s, double period_s) const noexcept;
  /// The push that counts for the texture, N: at most kMostCountedN, less what it wears away.
  [[nodiscard]] double counted_push_n(double push_n) const noexcept;

 private:
  const HeightField* field_;
  TextureLaw law_;
  double friction_;
  double bristle_n_per_m_;
  double wear_;
  double firm_push_n_;
  double gain_ = 0.0;  // kFriction: k in 1/mm; kGradient: factor of the slope
  double stiffness_n_per_m_ = 0.0;
};

}  // namespace felt
