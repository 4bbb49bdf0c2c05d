#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "felt/geometry/point.h"

namespace felt {

/// The samples that a curve fit looks at, one array per quantity so that the fit's inner loops
/// can take four samples at a time.
///
/// Samples nearer than the spacing to the last kept one are not stored: they only widen its
/// *slack*, the largest distance of any of them to it. A curve that stays within
/// (tolerance - slack) of a kept sample stays within the tolerance of all that it stands for, so
/// no sample is lost to the guarantee (R3, R8) and resting the pen costs nothing.
///
/// While drawing, the front is dropped as segments are committed and the arrays never grow beyond
/// the capacity given; at pen-up the refinement uses one that grows to the whole stroke.
class SampleWindow {
 public:
  /// Arrays are padded so that four lanes may be read at any sample.
  static constexpr std::size_t kPadding = 4;

  /// Part of the tolerance that is not used, so that a distance that someone measures by sampling
  /// the curve is still within it.
  static constexpr double kReserve = 1e-3;

  SampleWindow(double tolerance_mm, double spacing_mm, std::size_t capacity);

  /// Forgets all samples.
  void clear() noexcept;
  /// Takes a sample. True when it was kept, false when it was merged into the last kept one.
  bool add(Point p);
  /// Forgets the first `count` kept samples; indices shift down.
  void drop_front(std::size_t count) noexcept;

  [[nodiscard]] std::size_t size() const noexcept { return size_; }
  [[nodiscard]] std::size_t capacity() const noexcept { return x_.size() - kPadding; }
  [[nodiscard]] Point point(std::size_t i) const noexcept { return {x_[i], y_[i]}; }
  [[nodiscard]] const double* x() const noexcept { return x_.data(); }
  [[nodiscard]] const double* y() const noexcept { return y_.data(); }
  /// Path length in mm along the kept samples, from the first one of the stroke.
  [[nodiscard]] double path_mm(std::size_t i) const noexcept { return path_mm_[i]; }
  /// 1 / (tolerance - slack)^2: a squared distance times this is at most 1 when it is allowed.
  [[nodiscard]] const double* inverse_limit() const noexcept { return inverse_limit_.data(); }
  /// Number of samples that kept sample i stands for, itself included.
  [[nodiscard]] std::uint32_t sample_count(std::size_t i) const noexcept { return counts_[i]; }
  /// The newest sample, kept or merged.
  [[nodiscard]] Point newest() const noexcept { return newest_; }
  [[nodiscard]] double tolerance_mm() const noexcept { return tolerance_mm_; }

  /// Turn of the ink at sample i in radians where it may be a corner, else 0 (CornerDetector).
  [[nodiscard]] double turn(std::size_t i) const noexcept { return turns_[i]; }
  void set_turn(std::size_t i, double radians) noexcept { turns_[i] = radians; }
  [[nodiscard]] bool is_corner(std::size_t i) const noexcept { return corners_[i] != 0; }
  void set_corner(std::size_t i) noexcept { corners_[i] = 1; }

 private:
  void grow();

  double tolerance_mm_;
  double spacing_squared_;
  std::size_t size_ = 0;
  Point newest_;
  std::vector<double> x_, y_, path_mm_, inverse_limit_, slack_, turns_;
  std::vector<std::uint32_t> counts_;
  std::vector<std::uint8_t> corners_;
};

}  // namespace felt
