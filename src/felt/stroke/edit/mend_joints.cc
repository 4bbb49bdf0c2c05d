#include "felt/stroke/edit/mend_joints.h"

#include <algorithm>
#include <cstddef>
#include <numbers>

#include "felt/base/constants.h"
#include "felt/stroke/fit/segment_fit.h"

namespace felt {
namespace {

// The two sides of a joint: the segment that ends there and the one that starts there.
struct Joint {
  Point* in;
  Point* out;

  [[nodiscard]] Vec arriving() const {
    for (int k = 2; k >= 0; --k) {
      if (in[k] != in[3]) return in[3] - in[k];
    }
    return {};
  }
  [[nodiscard]] Vec leaving() const {
    for (int k = 1; k < 4; ++k) {
      if (out[k] != out[0]) return out[k] - out[0];
    }
    return {};
  }
  [[nodiscard]] double turn_deg() const {
    return angle_between(normalized(arriving()), normalized(leaving())) * kDegPerRad;
  }
};

// Rotates both handles to a direction between theirs, nearer to that of the longer one, so that
// both ends move by the same distance. If one handle is zero, only the other rotates.
bool straighten(const Joint& joint) {
  const bool has_in = joint.in[2] != joint.in[3], has_out = joint.out[1] != joint.out[0];
  const Vec arriving = joint.arriving(), leaving = joint.leaving();
  if (!(joint.turn_deg() <= kMaxMendedDeg) || !(has_in || has_out)) return false;
  const Vec both = has_in && has_out ? arriving + leaving : has_in ? leaving : arriving;
  const Vec along = normalized(both);
  const Point in = joint.in[2], out = joint.out[1];
  const Point new_in = has_in ? joint.in[3] - norm(arriving) * along : in;
  const Point new_out = has_out ? joint.out[0] + norm(leaving) * along : out;
  if (!(std::max(distance(in, new_in), distance(out, new_out)) < kMaxMendedMm)) return false;
  joint.in[2] = new_in;
  joint.out[1] = new_out;
  if (joint.turn_deg() <= kSmoothJointMaxDeg) return true;
  joint.in[2] = in;
  joint.out[1] = out;
  return false;
}

// Moves the end of a segment that is slightly too short outwards. The control points are p[0],
// p[step], p[2 * step], and the end p[3 * step].
bool lengthen(Point* p, std::ptrdiff_t step) {
  Point& end = p[3 * step];
  const Point before = p[2 * step];
  const double missing =
      kShortestSegmentMm - control_length(Cubic{{p[0], p[step], p[2 * step], end}});
  const Vec along = normalized(end - before);
  if (!(missing > kShortestSegmentMm - kMinSegmentMm) || along == Vec{}) return false;
  if (!(missing < 2.0 * kMaxMendedMm)) return false;
  end += missing * along;
  return true;
}

// Removes breakpoints that have the same u as another one, but never the first or the last one.
int drop_double_knots(std::vector<WidthKnot>& knots) {
  const std::size_t before = knots.size();
  if (before < 2) return 0;
  const WidthKnot last = knots.back();
  const auto same = [](const WidthKnot& a, const WidthKnot& b) { return a.u == b.u; };
  knots.erase(std::unique(knots.begin(), knots.end(), same), knots.end());
  if (knots.size() < 2) knots.push_back(last);
  knots.back() = last;
  return static_cast<int>(before - knots.size());
}

}  // namespace

MendedStroke mend_rounding(StrokeData& data) {
  MendedStroke mended;
  const std::size_t n = data.points.size() / 3;
  if (n == 0 || data.points.size() != 3 * n + 1 ||
      data.joints.size() != n - (data.closed ? 0 : 1)) {
    return mended;
  }
  for (const Point p : data.points) {
    if (!is_finite(p)) return mended;
  }
  for (std::size_t i = 0; i < data.joints.size(); ++i) {
    const Joint joint{&data.points[3 * i], &data.points[3 * ((i + 1) % n)]};
    if (data.joints[i] != JointKind::kSmooth || joint.turn_deg() <= kSmoothJointMaxDeg) continue;
    if (straighten(joint)) {
      ++mended.straightened;
    } else {
      data.joints[i] = JointKind::kCorner;
      ++mended.corners;
    }
  }
  if (!data.closed) {
    mended.lengthened += lengthen(&data.points[3 * (n - 1)], 1) ? 1 : 0;
    if (n > 1) mended.lengthened += lengthen(&data.points[3], -1) ? 1 : 0;
  }
  mended.knots = drop_double_knots(data.widths);
  return mended;
}

}  // namespace felt
