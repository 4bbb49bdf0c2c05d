#include "felt/devices/simulated/pseudo_cursor.h"

#include <algorithm>
#include <cmath>

namespace felt {
namespace {

Vec bounded(Vec v, double largest) noexcept {
  const double length = norm(v);
  return length > largest ? (largest / length) * v : v;
}

}  // namespace

Point PseudoCursor::update(Point hand, Point stylus, Use use, double dt_s) noexcept {
  const double max_mm = std::max(options_.max_mm, 0.0);
  if (!options_.on || use == Use::kTabletInk) {
    shown_ = {};
  } else if (use == Use::kFeeling) {
    const Vec wanted = options_.gain * (stylus - hand);
    shown_ = std::isfinite(norm(wanted)) ? bounded(wanted, max_mm) : Vec{};
  } else {
    const double step_mm = options_.release_s > 0.0 ? max_mm * dt_s / options_.release_s : max_mm;
    const double left_mm = norm(shown_) - std::max(step_mm, 0.0);
    shown_ = left_mm > 0.0 ? bounded(shown_, left_mm) : Vec{};
  }
  return hand + shown_;
}

}  // namespace felt
