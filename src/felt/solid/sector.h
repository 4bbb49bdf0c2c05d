#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "felt/solid/ring.h"

namespace felt {

/// The part of a symmetric area from which mirroring makes the whole, in the frame in which the
/// centre is (0, 0) and one axis is the x axis: all points at angles from 0 to pi / axes. Without
/// axes, the whole area.
struct Sector {
  int axes = 0;
  std::vector<Point> points;
  /// The edges of the border and those on axes, as indices of points.
  std::vector<std::array<std::size_t, 2>> edges;
};

/// Which of the two rays that bound a sector a point is on.
struct RayFlags {
  bool first = false;  ///< the ray at the angle 0
  bool last = false;   ///< the ray at the angle pi / axes
};

/// Returns the rays on which p is, within `tolerance_mm`. Both for the centre.
RayFlags rays_of(Point p, int axes, double tolerance_mm) noexcept;

/// Cuts a sector out of an area, and reduces its border to few points (border_points). The rings
/// are in the frame of the sector; the outer one turns from +x to +y, holes turn against it. Fails
/// with nullopt if the border only touches an axis, or crosses itself.
std::optional<Sector> cut_sector(std::span<const Ring> rings, int axes, const RingSpec& spec);

/// Returns a point where the border of a sector crosses itself, or nullopt.
std::optional<Point> crossing_of(const Sector& sector);

}  // namespace felt
