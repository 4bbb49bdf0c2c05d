#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "felt/geometry/point.h"
#include "felt/stroke/fit/kept_samples.h"

namespace felt {

struct FittedCurve;

/// A curve that a later fit of the same samples must stay close to, because the user has seen it
/// while drawing. A GuideCurve stores the point of that curve at each kept sample and at three
/// positions between each two neighbouring samples. So a check of closeness compares corresponding
/// points and takes only a few distance computations.
class GuideCurve {
 public:
  /// Points stored from one sample to the next.
  static constexpr std::size_t kPlaces = 4;

  /// Sets the guide: stores the points of `curve` at the kept samples. Requires that `curve` was
  /// fitted to exactly the samples that were added to `kept`.
  void follow(const KeptSamples& kept, const FittedCurve& curve);
  /// Removes the guide. Without a guide, every curve counts as close.
  void clear() noexcept { places_.clear(); }
  [[nodiscard]] bool empty() const noexcept { return places_.empty(); }

  /// Returns true if p is within `limit_mm` of the guide's point at kept sample i.
  [[nodiscard]] bool is_close_at(std::size_t i, Point p, double limit_mm) const noexcept;
  /// Returns true if the guide and the polyline `stretch` stay within `limit_mm` of each other
  /// between kept samples `from` and `to`. `stretch` contains points of the other curve between
  /// these samples, in order. Requires from < to.
  [[nodiscard]] bool is_close_between(std::size_t from, std::size_t to,
                                      std::span<const Point> stretch,
                                      double limit_mm) const noexcept;

 private:
  std::vector<Point> places_;  // kPlaces for each kept sample, up to the next one
};

}  // namespace felt
