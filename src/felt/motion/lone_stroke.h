#pragma once

#include <optional>
#include <span>

#include "felt/motion/inbetween.h"
#include "felt/motion/similarity.h"

namespace felt {

/// A stroke without partner, and how it moves.
struct LoneMotion {
  StrokePtr stroke;
  bool appears = false;  ///< it is in the second key drawing, not in the first
  Vec shift;             ///< how its neighbours moved in addition to the drawing, in the second key
};

/// Returns a stroke without partner at t, 0..1, or nullopt if it is invisible.
std::optional<Stroke> lone_stroke_at(const LoneMotion& lone, const Similarity& motion, double t,
                                     LoneStroke how);

/// A place in the first key drawing, and how far what is there has moved in addition to the
/// drawing.
struct LocalMotion {
  Point place;  ///< after the motion of the drawing
  Vec shift;
};

/// Returns the mean of the shifts near p, weighted by the inverse square of the distance (Shepard,
/// 1968, doi:10.1145/800186.810616). Zero if there is none.
Vec shift_near(std::span<const LocalMotion> motions, Point p, double near_mm) noexcept;

}  // namespace felt
