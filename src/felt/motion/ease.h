#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "felt/base/result.h"
#include "felt/document/key_timing.h"
#include "felt/geometry/point.h"

namespace felt {

/// How far a motion has come at each share of its time: a monotone function from 0..1 to 0..1.
class Ease {
 public:
  /// Makes a motion of constant speed.
  Ease() : Ease({{0.0, 0.0}, {1.0, 1.0}}) {}
  /// Makes the timing function cubic-bezier(x1, y1, x2, y2) of CSS Easing Functions Level 1
  /// (https://www.w3.org/TR/css-easing-1/). Fails unless all four numbers are from 0 to 1, because
  /// the motion would otherwise go back.
  static Result<Ease> cubic(double x1, double y1, double x2, double y2);
  /// Makes the timing function of a key drawing. Requires numbers from 0 to 1 (check_key_timing).
  static Ease of(const EaseCurve& curve);
  /// Makes the timing function "linear", "ease", "ease-in", "ease-out" or "ease-in-out" of CSS, or
  /// the one of four numbers separated by commas. Fails if the text is neither.
  static Result<Ease> parse(std::string_view text);
  /// Makes the motion that a line shows: time from its first to its last point in x, progress in y,
  /// upwards on the page or downwards. Where the line goes back, the motion waits. Fails if the
  /// ends of the line have the same x or y, or a coordinate is not finite.
  static Result<Ease> drawn(std::span<const Point> line);

  /// Returns the progress at a share of the time, which is clamped to 0..1. Exactly 0 at 0 and 1 at
  /// 1; never decreases.
  [[nodiscard]] double at(double time) const noexcept;

 private:
  /// A point of the function, which is linear between points.
  struct Knot {
    double time = 0.0, progress = 0.0;
  };
  explicit Ease(std::vector<Knot> knots) : knots_(std::move(knots)) {}

  std::vector<Knot> knots_;  // from (0, 0) to (1, 1), neither coordinate decreases
};

}  // namespace felt
