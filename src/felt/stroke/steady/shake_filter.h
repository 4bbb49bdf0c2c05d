#pragma once

#include <array>
#include <cstddef>

namespace felt {

/// Parameters of one model of a shaking pen along one axis.
struct ShakeModel {
  double hz = 5.0;              ///< frequency of the oscillation
  double swing_mm = 0.7;        ///< standard deviation of the oscillation; > 0
  double jerk_mm_per_s3 = 1e4;  ///< see ShakeFilter; > 0
};

/// The step of an oscillation over a time: turns by the angle w dt and decays.
struct ShakeStep {
  double dt_s = 0.0;
  double cos = 1.0, sin = 0.0;  ///< both times the decay
  double decay = 1.0;
};

/// Returns the step for a frequency and a time.
ShakeStep shake_step(double hz, double dt_s) noexcept;

/// Separates the intended motion of a pen from an oscillation of the hand, along one axis: a Kalman
/// filter (Gallego, Rocon, Roa, Moreno, Pons, Sensors 10:2129, 2010, DOI 10.3390/s100302129) with
///
///   intended motion   p' = v, v' = a, a' = white noise (constant acceleration)
///   oscillation       (c, s) turns with the frequency f0, decays with kDecayS, and is driven by
///                     noise that keeps its standard deviation at `swing_mm`
///   measurement       y = p + c + noise of kNoiseMm2
///
/// The intensity of the jerk noise is jerk^2 / 133 Hz, so `jerk_mm_per_s3` is the standard
/// deviation of the jerk over one sample of a usual tablet.
///
/// Earlier positions are revised by what came later as Rauch, Tung and Striebel do it (AIAA Journal
/// 3(8):1445, 1965, DOI 10.2514/3.3166), in the form of Bierman (Int. J. Control 18(1):65, 1973,
/// DOI 10.1080/00207177308932487), which gives the same result without inverting a covariance and
/// needs only one row of it per sample (Record). push() has no allocation and a constant cost.
class ShakeFilter {
 public:
  using State = std::array<double, 5>;  // p, v, a, c, s

  /// Chosen on one half of the strokes of bench/steady; the other half gives the figures in
  /// docs/figures.md.
  static constexpr double kDecayS = 1.5, kNoiseMm2 = 2e-4;
  /// Standard deviations of speed (mm/s) and acceleration (mm/s^2) at pen-down: a hand that already
  /// moves.
  static constexpr double kStartSpeed = 50.0, kStartAcceleration = 1000.0;

  /// What smoothing needs from one sample.
  struct Record {
    State row{};              ///< row p of the covariance after the sample
    State gain{};             ///< of the measurement
    double variance = 1.0;    ///< of the innovation
    double innovation = 0.0;  ///< measured minus predicted position, mm
    double position = 0.0;    ///< estimate of p after the sample, mm
    ShakeStep step{};         ///< from the sample before
  };
  /// The adjoint state of the backward recursion; zero after the newest sample.
  using Adjoint = std::array<double, 5>;

  explicit ShakeFilter(const ShakeModel& model = {}) noexcept : model_(model) {}

  [[nodiscard]] const ShakeModel& model() const noexcept { return model_; }
  /// Starts a line at a position.
  Record begin(double y_mm) noexcept;
  /// Adds the next measured position, one step later. Requires begin().
  Record push(double y_mm, const ShakeStep& step) noexcept;
  /// Returns the logarithm of the likelihood of the sample that gave this record.
  static double log_likelihood(const Record& record) noexcept;
  /// Returns the smoothed position of a sample, and moves the adjoint to the sample before it.
  static double smooth(const Record& record, Adjoint& adjoint) noexcept;

 private:
  using Covariance = std::array<State, 5>;

  void predict(const ShakeStep& step) noexcept;

  ShakeModel model_;
  State x_{};
  Covariance p_{};
};

}  // namespace felt
