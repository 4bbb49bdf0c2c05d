#pragma once

#include <cstdint>

namespace felt {

/// The form of the forces of equations 8 to 11.
enum class LawForm : std::uint8_t {
  kFelt,   ///< as read: without jumps, and no steeper than a device can render
  kPaper,  ///< as printed, without ramps and damping; for study, because it vibrates near a jump
};

/// The force with which an edit resists, as a function of distance (paper, eq. 8 and 9;
/// docs/design/forces.md#edit-law).
///
///   l(d)   = 0.2 + 0.8 d/(d + D)              N, d and D in mm
///   phi(d) = gain min(l(d), Kcap d)           F = -phi(|V|) V/|V|
///
/// The paper requires a force of 0.2..1 N that grows with d. l(d) satisfies this, but its jump to
/// 0.2 N at d = 0 would cause a limit cycle (up to 0.14 N above 30 Hz), so within the first 0.7 to
/// 0.9 mm the force is that of a spring of stiffness Kcap (docs/design/forces.md#edit-law). The
/// rational function l also grows strictly when computed in double precision, whereas 1 - exp(-d/D)
/// would become constant near 37 D.
///
/// The form kPaper is l itself: phi(d) = gain l(d) for d > 0, with the jump at 0.
struct ForceLaw {
  double spread_mm = 10.0;     ///< D: 10 for edits, 40 for transforms
  double cap_n_per_m = 300.0;  ///< Kcap, which is also the largest slope
  double min_n = 0.2;
  double max_n = 1.0;  ///< l approaches this force and never reaches it
  double gain = 1.0;   ///< 0..1: the strength that the user set for a tool
  LawForm form = LawForm::kFelt;

  /// Returns phi(d) in N; 0 if d <= 0.
  [[nodiscard]] double force_n(double distance_mm) const noexcept;
  /// Returns l(d) in N, without the spring near 0 and without the gain.
  [[nodiscard]] double level_n(double distance_mm) const noexcept;
  /// Returns the integral of phi from 0, in mJ: the energy that the hand has stored at a distance.
  [[nodiscard]] double potential_mj(double distance_mm) const noexcept;
  /// Returns this force law with Kcap multiplied by `share` (0..1): the spring near 0 is softer,
  /// and l does not change.
  [[nodiscard]] ForceLaw softened(double share) const noexcept;
  /// Returns an upper bound of d phi/dd, N/m, without the jump of the form kPaper.
  [[nodiscard]] double max_slope_n_per_m() const noexcept;
};

/// The force laws of local edits and of transforms.
inline constexpr ForceLaw kEditLaw{.spread_mm = 10.0};
inline constexpr ForceLaw kTransformLaw{.spread_mm = 40.0};

}  // namespace felt
