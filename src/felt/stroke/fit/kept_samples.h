#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "felt/base/chunked_vector.h"
#include "felt/geometry/point.h"

namespace felt {

/// The data points of a stroke: the samples that a curve fit keeps, from the first one on.
///
/// A sample within the spacing of the last kept sample is not stored. Instead, the last kept sample
/// represents it, or the next kept sample if that turns out to be nearer. The largest distance from
/// a kept sample to a sample that it represents is the *slack* of the kept sample. A curve that
/// stays within (tolerance - slack) of a kept sample stays within the tolerance of all samples that
/// it represents. So the tolerance holds for every sample (R3, R8), and a resting pen adds no kept
/// samples.
///
/// Adding a sample takes constant time and does not allocate after warm-up.
class KeptSamples {
 public:
  /// Fraction of the tolerance that is not used, so that a distance measured by sampling the curve,
  /// which is a little too large, is still within the tolerance.
  static constexpr double kReserve = 1e-3;

  KeptSamples(double tolerance_mm, double spacing_mm);

  /// Removes all samples.
  void clear() noexcept {
    samples_.clear();
    open_count_ = 0;
  }
  /// Adds a sample. Returns true if it was kept, false if it was merged.
  bool add(Point p);

  [[nodiscard]] std::size_t size() const noexcept { return samples_.size(); }
  [[nodiscard]] Point point(std::size_t i) const noexcept { return samples_[i].point; }
  /// Returns the path length in mm along the kept samples, from the first one of the stroke to
  /// sample i.
  [[nodiscard]] double path_mm(std::size_t i) const noexcept { return samples_[i].path_mm; }
  /// Returns 1 / (tolerance - slack)^2 of sample i, in 1/mm^2. A distance d from the sample is
  /// allowed if d^2 times this value is at most 1.
  [[nodiscard]] double inverse_limit(std::size_t i) const noexcept {
    return samples_[i].inverse_limit;
  }
  /// Returns the number of consecutive samples that kept sample i represents, itself included.
  [[nodiscard]] std::uint32_t sample_count(std::size_t i) const noexcept {
    return samples_[i].count;
  }
  /// Returns the newest sample, kept or merged.
  [[nodiscard]] Point newest() const noexcept { return newest_; }
  [[nodiscard]] double tolerance_mm() const noexcept { return tolerance_mm_; }

  /// Returns the turn of the ink at sample i in radians if it may be a corner, or 0 if not
  /// (CornerDetector).
  [[nodiscard]] double turn(std::size_t i) const noexcept { return samples_[i].turn; }
  void set_turn(std::size_t i, double radians) noexcept { samples_[i].turn = radians; }
  [[nodiscard]] bool is_corner(std::size_t i) const noexcept { return samples_[i].is_corner; }
  void set_corner(std::size_t i) noexcept { samples_[i].is_corner = true; }

 private:
  struct Sample {
    Point point;
    double path_mm = 0.0;
    double inverse_limit = 0.0;
    double slack = 0.0;
    double turn = 0.0;
    std::uint32_t count = 1;
    bool is_corner = false;
  };

  // Maximum number of merged samples that the next kept sample may still represent.
  static constexpr std::size_t kMaxOpen = 16;

  void set_slack(Sample& sample, double slack) const noexcept;
  void merge(Point p, double squared) noexcept;
  void share_open(Sample& next) noexcept;

  double tolerance_mm_;
  double spacing_squared_;
  Point newest_;
  std::array<Point, kMaxOpen> open_{};
  std::size_t open_count_ = 0;
  double settled_slack_ = 0.0;  // slack of the newest kept sample without open_
  ChunkedVector<Sample> samples_;
};

}  // namespace felt
