#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "felt/geometry/point.h"
#include "felt/haptics/force.h"
#include "felt/haptics/force_memory.h"
#include "felt/haptics/pen_sample.h"

namespace felt {

/// The attraction of a snap target by distance (paper, eq. 11; specification 5g, E17).
///
///   F(d) = Fp d/d0                        d < d0
///        = Fp                             d0 <= d <= M - w
///        = Fp S((d - (M - w))/w)          M - w < d < M,   S(x) = 1 - 3x^2 + 2x^3
///        = 0                              d >= M
///
/// Towards the target, zero and continuous at both ends, where the paper's l would jump by 0.2 N.
/// Lengths that do not fit (d0 + w > M) are read as d0 first, then w = M - d0.
struct WellShape {
  double radius_mm = 8.0;  ///< M
  double core_mm = 2.0;    ///< d0
  double rim_mm = 2.0;     ///< w
  double force_n = 0.6;    ///< Fp
  /// Calms the core beside a bristle at 3 ms of delay; on the known velocity, fading along the rim.
  double damping_n_s_per_m = 1.0;

  /// F in N, 0 at d <= 0 and d >= M; without the damping.
  [[nodiscard]] double force_at_n(double distance_mm) const noexcept;
  /// Energy that leads out of the well from the target to a distance, mJ; 3.6 mJ in all by default.
  [[nodiscard]] double potential_mj(double distance_mm) const noexcept;
  /// Stiffness at the target, N/m: its steepest pull back. The rim is up to 1.5 Fp/w steep the
  /// other way (it lets go), which no delay turns into an oscillation.
  [[nodiscard]] double core_slope_n_per_m() const noexcept;
  /// The well with a share (0..1) of its stiffness at the target: the core is wider and Fp stays,
  /// as far as there is room before the rim; beyond that Fp is less. The damping stays.
  [[nodiscard]] WellShape softened(double share) const noexcept;
  /// Share of the damping at a distance: 1 up to the rim, 0 from M.
  [[nodiscard]] double damped_share(double distance_mm) const noexcept;
};

/// Up to four snap targets. Their pulls add, so the force is continuous and has a potential
/// wherever they lie; a tool that wants the nearest alone gives one (R43). The dampings do not add.
///
/// A share s of the stiffness budget below 1 (R56) softens a single well by s^2
/// (WellShape::softened) and its damping by s, so that it attracts with Fp on slow loops too.
/// Several wells are scaled as a whole, and attract less there: a wider core does not bound what
/// overlapping wells add up to.
class Wells {
 public:
  static constexpr std::size_t kMax = 4;

  /// The first kMax of the targets.
  Wells(std::span<const Point> targets, const WellShape& shape = {}) noexcept;
  explicit Wells(Point target, const WellShape& shape = {}) noexcept
      : Wells(std::span<const Point>(&target, 1), shape) {}
  /// No target, no force.
  Wells() noexcept = default;

  Force operator()(const PenSample& sample, ForceMemory& memory) const noexcept;
  /// Where wells overlap, slopes add: that of the nearest core, and F/d of the others.
  [[nodiscard]] Slopes slopes() const noexcept;

 private:
  WellShape shape_;
  std::array<Point, kMax> targets_{};
  std::size_t count_ = 0;
};

}  // namespace felt
