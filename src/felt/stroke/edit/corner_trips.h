#pragma once

#include <optional>

#include "felt/stroke/stroke.h"

namespace felt {

/// Ink is a union of discs, so a pointed corner or a flat end of a broad line is drawn by short
/// trips of the line into the corner and back (docs/formats/svg.md). These trips are no lines of
/// their own.

/// Returns true if segment i and the next one are such a trip: the line returns along itself, and
/// one of both ways narrows to a point, at most 10 widths away. Requires 0 <= i < segment_count().
bool is_corner_trip(const Stroke& stroke, int i) noexcept;

/// Returns true if the stroke has such trips.
bool has_corner_trips(const Stroke& stroke) noexcept;

/// Returns the stroke without its trips: its corners and ends are round, and straight lines reach
/// to the middle of their flat ends. Joints where trips began become corners. Returns nullopt if
/// the stroke has no trips, or nothing else.
std::optional<Stroke> without_corner_trips(const Stroke& stroke);

}  // namespace felt
