#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "felt/geometry/point.h"
#include "felt/stroke/fit/kept_samples.h"

namespace felt {

/// The kept samples that one cubic is fitted to, one array per quantity so that the fit's inner
/// loops can take four of them at a time. A sample may stand for others around it: `weight` says
/// for how many, and `source` which kept sample of the stroke it is.
class SampleWindow {
 public:
  /// Arrays are padded so that four lanes may be read at any sample.
  static constexpr std::size_t kPadding = 4;
  /// Part of the limit of a sample that holds once samples were left out. The rest is for those:
  /// they lie between the ones that are kept, but not exactly.
  static constexpr double kThinnedShare = 0.97;

  explicit SampleWindow(std::size_t capacity);

  /// Forgets all samples.
  void clear() noexcept;
  /// Adds kept sample `source`. Requires size() < capacity().
  void add(const KeptSamples& kept, std::size_t source) noexcept;
  /// The newest sample is never left out.
  void hold_newest() noexcept { is_held_[size_ - 1] = 1; }
  /// Leaves samples out, so that a window that is full has room again, about a quarter. Of four
  /// neighbours that stand for few others those with the least `left` and the greatest `right`
  /// stay; what the four stand for is divided between these. The first and the last sample and
  /// those held always stay. Indices shift down; `parameters` is reduced in the same way. Each
  /// array has one value for each sample.
  void thin(const double* left, const double* right, double* parameters) noexcept;

  [[nodiscard]] std::size_t size() const noexcept { return size_; }
  [[nodiscard]] std::size_t capacity() const noexcept { return x_.size() - kPadding; }
  /// True if samples were left out since clear().
  [[nodiscard]] bool is_thinned() const noexcept { return is_thinned_; }
  [[nodiscard]] Point point(std::size_t i) const noexcept { return {x_[i], y_[i]}; }
  [[nodiscard]] const double* x() const noexcept { return x_.data(); }
  [[nodiscard]] const double* y() const noexcept { return y_.data(); }
  /// Path length in mm along the kept samples, from the first one of the stroke.
  [[nodiscard]] double path_mm(std::size_t i) const noexcept { return path_mm_[i]; }
  /// A squared distance times this is at most 1 if it is allowed.
  [[nodiscard]] const double* inverse_limit() const noexcept { return inverse_limit_.data(); }
  /// How many kept samples each one stands for. 1 unless samples were left out.
  [[nodiscard]] const double* weight() const noexcept { return weight_.data(); }
  /// Which kept sample of the stroke sample i is.
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
