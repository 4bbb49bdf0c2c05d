#pragma once

#include <cmath>

#include "felt/geometry/point.h"
#include "felt/geometry/triangle_tree.h"
#include "felt/geometry/vec3.h"

namespace felt {

/// The picture that an eye at infinity has of a solid: the axes of a right-handed frame.
struct ViewFrame {
  Vec3 right{1.0, 0.0, 0.0};
  Vec3 up{0.0, 1.0, 0.0};
  Vec3 towards{0.0, 0.0, 1.0};  ///< from the solid to the eye

  /// Returns the position in the picture, in mm.
  [[nodiscard]] Point to_picture(const Vec3& p) const noexcept {
    return {dot(right, p), dot(up, p)};
  }
  /// Returns the distance towards the eye, in mm.
  [[nodiscard]] double depth(const Vec3& p) const noexcept { return dot(towards, p); }
  /// Returns the point of the solid at a position of the picture and a depth.
  [[nodiscard]] Vec3 to_solid(Point p, double depth_mm) const noexcept {
    return p.x * right + p.y * up + depth_mm * towards;
  }
};

/// Returns the frame for a view direction, from the eye to the solid, of any length but 0. Up in
/// the picture is y of the solid, or as near to it as possible.
inline ViewFrame view_frame(const Vec3& view) noexcept {
  ViewFrame frame;
  frame.towards = (-1.0 / norm(view)) * view;
  const Vec3 right = cross(Vec3{0.0, 1.0, 0.0}, frame.towards);
  const double length = norm(right);
  frame.right = length > 1e-9 ? (1.0 / length) * right : Vec3{1.0, 0.0, 0.0};
  frame.up = cross(frame.towards, frame.right);
  return frame;
}

}  // namespace felt
