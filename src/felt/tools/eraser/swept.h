#pragma once

#include "felt/geometry/rect.h"
#include "felt/stroke/stroke.h"
#include "felt/tools/eraser/parameter_set.h"

namespace felt {

/// What a round eraser covers while it goes straight from one place to another.
struct Capsule {
  Point from;
  Point to;
  double radius_mm = 2.0;
  /// The radius grows by half the width of the ink: what the eye sees touched is touched.
  bool adds_half_width = false;
  /// What lies around `from` was covered before: the capsule goes on from another one's end.
  bool goes_on = false;

  /// Around the axis.
  [[nodiscard]] Rect axis_bounds() const noexcept {
    Rect box;
    box.extend(from);
    box.extend(to);
    return box;
  }
  /// Around all of it, without what broad ink adds.
  [[nodiscard]] Rect bounds() const noexcept { return axis_bounds().inflated(radius_mm); }
};

/// Adds {u : dist(f(u), axis) < radius} of one segment of a stroke to `swept` (specification 5f,
/// R39); true when it grew.
///
/// A capsule is two discs and a rectangle, and a place is in it when it is in one of them. With
/// the radius r linear between width breakpoints, each is a polynomial below zero in Bernstein
/// form:
///   disc        |f - p|^2 - r^2                                      degree 6
///   rectangle   n.(f - p) - r, -n.(f - p) - r, -d.(f - p), d.(f - p) - L,    all four, degree 3
/// so below_zero() misses no grazing touch and the ends of the intervals are right to rounding:
/// 1e-12 of t, about sqrt(rounding) where a graze is as shallow as that.
bool add_swept(const Stroke& stroke, int segment, const Capsule& capsule, ParameterSet& swept);

}  // namespace felt
