#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "felt/stroke/outline/outline.h"
#include "felt/tactile/touch_lines.h"

namespace felt {

/// A straight black line, or a dot if both points are equal.
struct TextureLine {
  Point from{}, to{};
};

/// Everything that the texture of an area needs to know. The area is the even-odd inside of
/// `edges` without the even-odd insides of `above`.
struct TextureArea {
  const Outline& edges;
  const std::vector<Outline>& above;  ///< of the areas that lie on it
  const TouchLines& ink;
  const TouchGrid& near_ink;  ///< of `ink`; its cells are at least as wide as white plus ink
};

/// Returns the lines of a texture: 0 and 1 are lines across and down, 2 dots, 3 a grid, 4 slanted
/// lines. Every point is inside the area and at least SwellRules::kWhiteMm from its edges and from
/// all ink. Returns nullopt if this needs more than `tests_left` tests of a point against an edge;
/// otherwise lowers `tests_left` by their number.
std::optional<std::vector<TextureLine>> texture_of(const TextureArea& area, std::size_t kind,
                                                   std::size_t& tests_left);

/// Returns the parts of the edges along which there is no ink, as polylines; a closed edge without
/// any ink repeats its first point.
std::vector<std::vector<Point>> bare_edges(const Outline& edges, const TouchLines& ink,
                                           const TouchGrid& near_ink);

}  // namespace felt
