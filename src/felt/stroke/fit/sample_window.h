#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "felt/geometry/point.h"
#include "felt/stroke/fit/kept_samples.h"

namespace felt {

/// The kept samples (KeptSamples) to which one cubic is fitted, one array per quantity, so that the
/// fit's inner loops can process four samples at a time. A sample may represent others around it:
/// its `weight` is the number of kept samples that it represents, including itself, and its
/// `source` is its own index among the kept samples of the stroke.
class SampleWindow {
 public:
  /// Number of padding elements of each array, so that four elements can be read starting at any
  /// sample.
  static constexpr std::size_t kPadding = 4;
  /// After samples have been left out (thin()), every allowed distance is reduced to this fraction.
  /// The remaining 3 % are a reserve, because the omitted samples lie only approximately between
  /// those that stay.
  static constexpr double kThinnedShare = 0.97;

  explicit SampleWindow(std::size_t capacity);

  /// Removes all samples.
  void clear() noexcept;
  /// Adds kept sample `source`. Requires size() < capacity().
  void add(const KeptSamples& kept, std::size_t source) noexcept;
  /// Marks the newest sample as held, so that thin() never leaves it out.
  void hold_newest() noexcept { is_held_[size_ - 1] = 1; }
  /// Leaves samples out, so that at least about a quarter of a full window becomes free. Of four
  /// neighbours that together represent a small part of all samples, only the two stay that lie
  /// farthest to either side of the curve: the one with the smallest value in `left` (signed
  /// distance from the curve minus the slack of the sample) and the one with the largest value in
  /// `right` (the distance plus the slack). Each of the two then represents half of the samples
  /// that the four represented. The first, the last and all held samples always stay. The samples
  /// that stay move to the front of the window, and their values in `parameters` move with them.
  /// Each of the three arrays must have one value for each sample.
  void thin(const double* left, const double* right, double* parameters) noexcept;

  [[nodiscard]] std::size_t size() const noexcept { return size_; }
  [[nodiscard]] std::size_t capacity() const noexcept { return x_.size() - kPadding; }
  /// Returns true if samples were left out since clear().
  [[nodiscard]] bool is_thinned() const noexcept { return is_thinned_; }
  [[nodiscard]] Point point(std::size_t i) const noexcept { return {x_[i], y_[i]}; }
  [[nodiscard]] const double* x() const noexcept { return x_.data(); }
  [[nodiscard]] const double* y() const noexcept { return y_.data(); }
  /// Returns the path length in mm along the kept samples, from the first one of the stroke to
  /// sample i.
  [[nodiscard]] double path_mm(std::size_t i) const noexcept { return path_mm_[i]; }
  /// Returns KeptSamples::inverse_limit of each sample. After samples have been left out, the
  /// values are those of the reduced limit (kThinnedShare). A squared distance is allowed if its
  /// product with this value is at most 1.
  [[nodiscard]] const double* inverse_limit() const noexcept { return inverse_limit_.data(); }
  /// Returns, for each sample, the number of kept samples that it represents. All numbers are 1
  /// unless samples were left out.
  [[nodiscard]] const double* weight() const noexcept { return weight_.data(); }
  /// Returns the index of sample i among the kept samples of the stroke.
  [[nodiscard]] std::size_t source(std::size_t i) const noexcept { return source_[i]; }
  [[nodiscard]] double tolerance_mm() const noexcept { return tolerance_mm_; }

 private:
  void move(std::size_t from, std::size_t to) noexcept;

  double tolerance_mm_ = 0.0;
  std::size_t size_ = 0;
  bool is_thinned_ = false;
  std::vector<double> x_, y_, path_mm_, inverse_limit_, weight_;
  std::vector<std::size_t> source_;
  std::vector<std::uint8_t> is_held_;
};

}  // namespace felt
