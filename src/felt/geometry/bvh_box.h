#pragma once

// Private to the bvh sources: single-precision boxes, rounded outwards, so that they always contain
// the exact box.

#include <algorithm>
#include <cmath>
#include <limits>

#include "felt/geometry/bvh.h"

namespace felt {

/// Coordinates are clamped to kBvhFarthest before they become floats, so that squares stay finite.
/// Clamping can only shorten the distances to boxes, so these distances stay lower bounds.
inline constexpr double kBvhFarthest = 1e18;

/// Returns the largest float not above v.
inline float float_below(double v) noexcept {
  v = std::clamp(v, -kBvhFarthest, kBvhFarthest);
  const auto f = static_cast<float>(v);
  return static_cast<double>(f) <= v ? f : std::nextafter(f, -std::numeric_limits<float>::max());
}

/// Returns the smallest float not below v.
inline float float_above(double v) noexcept {
  return -float_below(-v);
}

/// A box of floats; the default one is empty.
struct SegmentBvh::Box {
  float x0 = std::numeric_limits<float>::infinity();
  float y0 = std::numeric_limits<float>::infinity();
  float x1 = -std::numeric_limits<float>::infinity();
  float y1 = -std::numeric_limits<float>::infinity();

  Box() = default;
  /// The box of a rectangle, rounded outwards.
  explicit Box(const Rect& r) noexcept {
    if (r.empty()) return;
    x0 = float_below(r.x0), y0 = float_below(r.y0);
    x1 = float_above(r.x1), y1 = float_above(r.y1);
  }
  /// The box of all children of a node.
  explicit Box(const Node& n) noexcept {
    for (unsigned i = 0; i < kFanOut; ++i) {
      x0 = std::min(x0, n.x0[i]), y0 = std::min(y0, n.y0[i]);
      x1 = std::max(x1, n.x1[i]), y1 = std::max(y1, n.y1[i]);
    }
  }
  /// The box of child i of a node.
  Box(const Node& n, unsigned i) noexcept : x0(n.x0[i]), y0(n.y0[i]), x1(n.x1[i]), y1(n.y1[i]) {}

  void store(Node& n, unsigned i) const noexcept {
    n.x0[i] = x0, n.y0[i] = y0, n.x1[i] = x1, n.y1[i] = y1;
  }

  [[nodiscard]] double half_perimeter() const noexcept {
    return x0 <= x1 ? (static_cast<double>(x1) - static_cast<double>(x0)) +
                          (static_cast<double>(y1) - static_cast<double>(y0))
                    : 0.0;
  }

  friend bool operator==(const Box&, const Box&) noexcept = default;
};

}  // namespace felt
