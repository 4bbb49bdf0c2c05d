#pragma once

#include <array>
#include <complex>
#include <cstddef>
#include <span>
#include <vector>

#include "felt/geometry/point.h"

namespace felt {

/// Separates the intended motion of a complete line from the shaking of the hand, and learns from
/// the line itself how both change: the intensity of the intended jerk and the frequency of the
/// shaking at each moment, and the amplitude (docs/design/steady-hand.md, "At pen-up").
///
/// The line is given at nodes, `step_s` apart, along and across the axis of the shaking. At node k
/// and for each axis,
///
///   measured position   y_k = x_k + c_k + noise of kNoiseMm2
///   intended motion     x_k: its third difference is noise with the variance v_k
///   shaking             (c, s)_k+1 = decayed (c, s)_k, turned by the angle w_k, plus noise
///
/// A pass computes means and covariances of all x, c and s given all y, and then the v, w and
/// amplitudes that explain them best: expectation maximisation (Shumway, Stoffer, J. Time Series
/// Analysis 3(4):253, 1982, DOI 10.1111/j.1467-9892.1982.tb00349.x). v and w are means over a short
/// time around each node. A pass takes linear time: the equations are banded, and their
/// elimination keeps 5 unknowns.
class ShakeSmoother {
 public:
  /// Where the passes start.
  struct Start {
    double hz = 5.0;
    double jerk_mm_per_s3 = 8000.0;  ///< as in ShakeModel
  };
  /// The usual distance of nodes: that of the samples of a tablet at 133 Hz.
  static constexpr double kStepS = 0.0075;

  /// `swing_mm` are the standard deviations of the shaking along and across the axis, and `hz` is
  /// its mean frequency. `nodes` must outlive the smoother. Requires: step_s > 0.
  ShakeSmoother(std::span<const Vec> nodes, double step_s, double hz, Vec swing_mm);

  /// Makes passes and returns the shaking at each node, along and across the axis; valid until the
  /// next call.
  std::span<const Vec> shaking(const Start& start, int passes);
  /// Returns the geometric mean of the jerk that the last passes found, as in ShakeModel.
  [[nodiscard]] double jerk_mm_per_s3() const noexcept;
  /// Returns the frequency at node k that the last passes found.
  [[nodiscard]] double hz(std::size_t k) const noexcept;

 private:
  /// The unknowns of a node and those of later nodes that its elimination couples to it.
  static constexpr std::size_t kOwn = 3;    // x, c, s
  static constexpr std::size_t kFront = 5;  // x, c, s of the next node, x of the next two
  /// The eliminated equations of a node: own = mean - link * front, and the covariance of the rest.
  struct Eliminated {
    std::array<std::array<double, kFront>, kOwn> link;
    std::array<std::array<double, kOwn>, kOwn> covariance;
    std::array<double, kOwn> mean;
  };

  /// Means and covariances of the own unknowns and the front of a node.
  struct Moments {
    const double (&own)[kOwn];
    const double (&front)[kFront];
    const double (&inner)[kOwn][kOwn];
    const double (&across)[kOwn][kFront];
    const double (&cov)[kFront][kFront];
  };

  void eliminate(std::size_t axis);
  void substitute(std::size_t axis);
  void see(std::size_t axis, std::size_t k, const Moments& is);
  void learn_jerk();
  void learn_frequency();
  void learn_swing();

  std::span<const Vec> nodes_;
  double step_s_, angle_;               // angle: of the mean frequency over a step
  std::array<double, 2> prior_, size_;  // variances of the shaking
  double decay_;
  std::vector<double> jerk_, turn_;  // v and w at each node
  std::vector<std::complex<double>> rotation_;
  std::vector<double> jerk_seen_;                // squared third differences, expected
  std::vector<std::complex<double>> turn_seen_;  // expected conj(z_k) z_k+1, z = c + i s
  std::array<double, 2> fresh_{};                // squared noise of the shaking, expected sum
  std::vector<Eliminated> equations_;
  std::vector<Vec> shaking_;
};

}  // namespace felt
