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
/// A capsule is the union of two discs and a rectangle. Because the radius r is linear between
/// width breakpoints, a point is inside one of them if these polynomials in Bernstein form are
/// below zero, with p the centre of the disc or the start of the axis, d and n the unit direction
/// and normal of the axis, and L its length:
///   disc        |f - p|^2 - r^2                                      degree 6
///   rectangle   n.(f - p) - r, -n.(f - p) - r, -d.(f - p), d.(f - p) - L,    all four, degree 3
/// below_zero() finds these parts without missing a grazing touch. The ends of the intervals are
/// exact up to rounding: 1e-12 of t, or about the square root of the rounding error if the capsule
/// only grazes the ink.
bool add_swept(const Stroke& stroke, int segment, const Capsule& capsule, ParameterSet& swept);

}  // namespace felt
