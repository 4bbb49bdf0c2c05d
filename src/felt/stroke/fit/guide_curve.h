#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "felt/geometry/point.h"
#include "felt/stroke/fit/kept_samples.h"

namespace felt {

struct FittedCurve;

/// A curve that a later fit of the same samples must stay close to: what the user has been looking
/// at while drawing. At each kept sample and at three places between neighbours it knows where
/// that curve was, so closeness is checked between corresponding places and costs a few distances.
class GuideCurve {
 public:
  /// Places kept from one sample to the next.
  static constexpr std::size_t kPlaces = 4;

  /// Takes the places of the kept samples on `curve`, which was fitted to exactly the samples that
  /// `kept` was given.
  void follow(const KeptSamples& kept, const FittedCurve& curve);
  /// Follows nothing: everything is close.
  void clear() noexcept { places_.clear(); }
  [[nodiscard]] bool empty() const noexcept { return places_.empty(); }

  /// True when p is within `limit_mm` of the curve's place at kept sample i.
  [[nodiscard]] bool is_close_at(std::size_t i, Point p, double limit_mm) const noexcept;
  /// True when the two curves stay within `limit_mm` of each other between kept samples `from` and
  /// `to`, where the other one passes through `stretch`, in order. Requires from < to.
  [[nodiscard]] bool is_close_between(std::size_t from, std::size_t to,
                                      std::span<const Point> stretch,
                                      double limit_mm) const noexcept;

 private:
  std::vector<Point> places_;  // kPlaces for each kept sample: at it, and on the way to the next
};

}  // namespace felt
