#pragma once

#include <cstdint>
#include <optional>

#include "felt/geometry/point.h"
#include "felt/stroke/stroke.h"
#include "felt/tools/scene.h"

namespace felt {

/// What the shape tool draws. The values are the indices of kShapeKinds.
enum class ShapeKind : std::uint8_t { kLine, kRectangle, kEllipse };

/// Modifiers of a shape.
struct ShapeRules {
  bool is_regular = false;      ///< a square, a circle, or a line in a direction of k * 15 degrees
  bool is_from_centre = false;  ///< the first point is the centre
};

/// The two opposite corners of a shape, or the two ends of a line.
struct ShapeCorners {
  Point from, to;
};

/// Smallest width and height of a shape, and smallest length of a line, in mm.
inline constexpr double kMinShapeMm = 0.2;

/// Returns the corners of the shape between the point where the pen touched down and the pen.
ShapeCorners shape_corners(ShapeKind kind, Point touch, Point pen,
                           const ShapeRules& rules) noexcept;

/// Returns the stroke of a shape, in the medium, colour and width of new ink. Returns nullopt if it
/// is smaller than kMinShapeMm.
std::optional<Stroke> shape_stroke(ShapeKind kind, const ShapeCorners& corners, const Scene& scene);

}  // namespace felt
