#pragma once

#include "felt/geometry/rect.h"
#include "felt/stroke/stroke.h"
#include "felt/tools/eraser/parameter_set.h"

namespace felt {

/// The area that a round eraser covers on a straight path.
struct Capsule {
  Point from;
  Point to;
  double radius_mm = 2.0;
  /// If true, half the width of the ink is added to the radius, so that all ink that looks touched
  /// is touched.
  bool adds_half_width = false;
  /// If true, the disc around `from` was covered before, because the capsule continues another one.
  bool goes_on = false;

  /// Returns the bounding box of the axis.
  [[nodiscard]] Rect axis_bounds() const noexcept {
    Rect box;
    box.extend(from);
    box.extend(to);
    return box;
  }
  /// Returns the bounding box of the capsule, without half the width of the ink.
  [[nodiscard]] Rect bounds() const noexcept { return axis_bounds().inflated(radius_mm); }
};

/// Adds {u : dist(f(u), axis) < radius} of one segment of a stroke to `swept`
/// (docs/design/editing.md#eraser, R39). Returns true if `swept` grew.
///
/// A capsule is the union of two discs and a rectangle. With the radius r linear between width
/// breakpoints, a point is inside one of these if polynomials in Bernstein form are below zero:
///   disc        |f - p|^2 - r^2                                      degree 6
///   rectangle   n.(f - p) - r, -n.(f - p) - r, -d.(f - p), d.(f - p) - L,    all four, degree 3
/// So below_zero() does not miss a grazing touch. The ends of the intervals are exact up to
/// rounding: 1e-12 of t, or about the square root of the rounding error if the capsule only grazes
/// the ink.
bool add_swept(const Stroke& stroke, int segment, const Capsule& capsule, ParameterSet& swept);

}  // namespace felt
