#pragma once

#include <span>

#include "felt/geometry/point.h"

namespace felt {

/// Edges do not become shorter than this share of their length.
inline constexpr double kMinEdgeShare = 0.25;

/// Changes the lengths of the edges of a polygon so that it ends where it should, and returns the
/// distance that is left, in mm. `gap` is the displacement by which the end must move. Directions
/// stay. The changes are the smallest ones relative to the lengths: edges of one direction change
/// by the same factor (Sederberg and others, 1993, section 4, with the length as the weight).
double close_gap(std::span<double> lengths, std::span<const Vec> directions, Vec gap) noexcept;

}  // namespace felt
