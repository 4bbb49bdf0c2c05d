#pragma once

#include <span>

#include "felt/motion/similarity.h"
#include "felt/motion/stroke_shape.h"

namespace felt {

/// Estimates how a drawing as a whole moved between two key drawings, without knowing which strokes
/// belong together. Tries motions that move single long strokes onto similar strokes (the
/// hypothesise-and-test scheme of RANSAC, Fischler and Bolles, 1981, doi:10.1145/358669.358692),
/// the motion of the centres, and no motion, and returns the one that leaves the strokes nearest to
/// strokes of the other drawing. Between equally good motions, prefers the smaller one.
///
/// Returns no motion if a drawing has no stroke. Takes at most linear time in the number of strokes
/// of `b` and a constant number of strokes of `a`.
Similarity estimate_group_motion(std::span<const StrokeShape> a, std::span<const StrokeShape> b);

/// Returns the shape after the motion.
StrokeShape moved(const Similarity& motion, const StrokeShape& shape) noexcept;

/// Returns the diagonal of the box around all points of the shapes, in mm.
double diagonal_mm(std::span<const StrokeShape> shapes) noexcept;

}  // namespace felt
