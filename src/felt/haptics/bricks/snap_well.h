#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "felt/geometry/point.h"
#include "felt/haptics/force.h"
#include "felt/haptics/force_law.h"
#include "felt/haptics/force_memory.h"
#include "felt/haptics/pen_sample.h"

namespace felt {

/// The attraction of a snap target as a function of distance (paper, eq. 11;
/// docs/design/forces.md#snap-well).
///
///   F(d) = Fp d/d0                        d < d0
///        = Fp                             d0 <= d <= M - w
///        = Fp S((d - (M - w))/w)          M - w < d < M,   S(x) = 1 - 3x^2 + 2x^3
///        = 0                              d >= M
///
/// The force points towards the target, is continuous, and is zero at d = 0 and from d = M on. The
/// paper's force law l (ForceLaw) would jump by 0.2 N at d = 0. If the lengths do not fit (d0 + w >
/// M), d0 has priority and w = M - d0.
///
/// The form kPaper is equation 11 as printed, F(d) = Fp l(d) for 0 < d < M, with l of kEditLaw,
/// which approaches 1. It jumps at both ends (docs/design/errata.md#e17).
struct WellShape {
  double radius_mm = 8.0;  ///< M
  double core_mm = 2.0;    ///< d0
  double rim_mm = 2.0;     ///< w
  double force_n = 0.6;    ///< Fp
  /// Damping. It keeps the core calm at a delay of 3 ms even when a friction bristle adds
  /// stiffness. It acts on known_velocity() and decreases to 0 along the rim.
  double damping_n_s_per_m = 1.0;
  LawForm form = LawForm::kFelt;

  /// Returns F without the damping, in N; 0 if d <= 0 or d >= M.
  [[nodiscard]] double force_at_n(double distance_mm) const noexcept;
  /// Returns the energy needed to pull the pen from the target to a distance, mJ. With the default
  /// values, 3.6 mJ are needed to leave the well.
  [[nodiscard]] double potential_mj(double distance_mm) const noexcept;
  /// Returns the stiffness at the target, N/m, which is the largest stiffness of the well; 0 in the
  /// form kPaper, whose jumps do not count. In the
  /// rim, the force falls with distance by up to 1.5 Fp/w; such a negative stiffness causes no
  /// oscillation at any delay.
  [[nodiscard]] double core_slope_n_per_m() const noexcept;
  /// Returns this well with its stiffness at the target multiplied by `share` (0..1). The core
  /// becomes wider, and Fp does not change. If the core would then overlap the rim, it ends at the
  /// rim, and Fp is reduced instead. The damping does not change, nor does the form kPaper.
  [[nodiscard]] WellShape softened(double share) const noexcept;
  /// Returns the share of the damping at a distance: 1 up to the rim, 0 from M on.
  [[nodiscard]] double damped_share(double distance_mm) const noexcept;
  /// Returns equation 11 as printed within the radius of this well, times `gain`, without damping.
  /// A well without force stays without force.
  [[nodiscard]] WellShape printed(double gain) const noexcept;
};

/// Up to four snap targets. Their forces add, so the sum is continuous and has a potential wherever
/// the targets are. If a tool needs only the nearest target, it passes only that target (R43).
/// Their dampings do not add; only the strongest one acts.
///
/// If the share s of the stiffness budget is below 1 (R56), a single well is softened by s^2
/// (WellShape::softened) and its damping by s, so that it attracts with Fp on slow loops, too.
/// Several wells are not softened, because wider cores would not bound the stiffness of overlapping
/// wells. Instead their force is multiplied by s, so they attract less.
class SnapWells {
 public:
  static constexpr std::size_t kMax = 4;

  /// Makes wells at the first kMax targets; ignores the others.
  SnapWells(std::span<const Point> targets, const WellShape& shape = {}) noexcept;
  explicit SnapWells(Point target, const WellShape& shape = {}) noexcept
      : SnapWells(std::span<const Point>(&target, 1), shape) {}
  /// Makes wells without a target and without force.
  SnapWells() noexcept = default;

  Force operator()(const PenSample& sample, ForceMemory& memory) const noexcept;
  /// Returns an upper bound of the stiffness. If wells overlap, the bound is the slope of the
  /// nearest core plus F/d for every further well.
  [[nodiscard]] Slopes slopes() const noexcept;

 private:
  WellShape shape_;
  std::array<Point, kMax> targets_{};
  std::size_t count_ = 0;
};

}  // namespace felt
