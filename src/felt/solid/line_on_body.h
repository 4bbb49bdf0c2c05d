#pragma once

#include <span>
#include <vector>

#include "felt/solid/solid.h"

namespace felt {

/// A part of a stroke that lies on a body: points of the surface with the normals there.
struct LineOnBody {
  std::vector<Vec3> points;   ///< mm, in the frame of the body
  std::vector<Vec3> normals;  ///< unit vectors, outwards
};

/// Projects a stroke on a body along `view` (from the eye to the body): each point moves to the
/// first surface that the eye sees there. Points are about `step_mm` apart, but at most
/// kMaxProjectedPoints. Where the stroke leaves the body, or jumps by more than a few steps in
/// depth, a new part begins. Returns no part if the stroke does not meet the body.
std::vector<LineOnBody> projected_line(const SolidBody& body, std::span<const Vec3> path,
                                       const Vec3& view, double step_mm);
inline constexpr int kMaxProjectedPoints = 2000;

/// Finds the points of lines near a position.
class LineSearch {
 public:
  /// Requires lines with at least one point together; they must outlive the search.
  explicit LineSearch(std::span<const LineOnBody> lines);

  /// The nearest position on a line.
  struct Near {
    double distance_mm = 0.0;
    Vec3 normal;  ///< of the surface there
  };
  /// Returns the nearest position on a line within `radius_mm`; distance_mm is larger if there is
  /// none.
  [[nodiscard]] Near nearest(const Vec3& p, double radius_mm) const;

 private:
  struct Segment {
    Vec3 a, b, normal;
    double middle;  // along axis_
  };
  double Vec3::*axis_ = &Vec3::x;  // along which the lines are longest
  std::vector<Segment> segments_;  // sorted by `middle`
  double longest_ = 0.0;
};

}  // namespace felt
