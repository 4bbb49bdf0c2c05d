#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "felt/base/result.h"
#include "felt/document/id.h"
#include "felt/geometry/point.h"
#include "felt/geometry/triangle_tree.h"
#include "felt/geometry/vec3.h"
#include "felt/stroke/stroke.h"

namespace felt {

/// The closed surface of one body, in mm. x points right, y up and z towards the viewer: unlike on
/// the page, y points up, so that the axes are right-handed.
struct SolidBody {
  using Triangle = std::array<std::uint32_t, 3>;

  std::vector<Vec3> points;
  std::vector<Triangle> triangles;  ///< counter-clockwise, seen from outside
  /// The first points lie on the outline, with z = 0. The front and the back share them.
  /// 0 if the body has been edited (body_edits.h).
  std::size_t border_count = 0;
  int holes = 0;    ///< the number of holes through the body
  StrokeId stroke;  ///< the stroke with the largest share of the outline
  Rgba color{};     ///< of that stroke
  /// The colour that is painted on each point (paint_body()), not premultiplied; alpha 0 where
  /// nothing is. Empty if nothing is painted on the body.
  std::vector<Rgba> paint;
};

/// Bodies without common points.
struct Solid {
  std::vector<SolidBody> bodies;
  /// The point of the page at x = y = 0. A point (x, y, z) lies above (origin.x + x, origin.y - y)
  /// of the page.
  Point origin;
};

/// Returns the volume in mm^3; positive if the triangles are counter-clockwise from outside.
double volume_mm3(const SolidBody& body) noexcept;

/// Returns the number of triangles of all bodies.
std::size_t triangle_count(const Solid& solid) noexcept;

/// Returns the triangles of all bodies in the frame of the page (z = 0 is the plane of the
/// outlines, y points down), lowered by `lowered_mm`. As that frame is left-handed, the corners are
/// in the order in which Triangle3 has its front outside the body.
std::vector<Triangle3> page_triangles(const Solid& solid, double lowered_mm = 0.0);

/// The normals of the smooth surface at the points of a body: unit vectors that point outwards.
std::vector<Vec3> point_normals(const SolidBody& body);

/// Checks that a body stays closed if its coordinates are rounded to float, as files store them:
/// every coordinate is finite, no two points are equal, no triangle is degenerate, and every edge
/// belongs to exactly two triangles, in opposite directions. The message says where on the page the
/// body breaks; `origin` is that of the solid.
Result<void> check_body(const SolidBody& body, Point origin);

}  // namespace felt
