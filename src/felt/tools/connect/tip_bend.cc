#include "felt/tools/connect/tip_bend.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "felt/stroke/edit/split.h"

namespace felt {
namespace {

constexpr double kBendAccuracy = 1e-3;

/// A zero-length handle at a smooth joint gets this length (join.cc), so that its direction does
/// not depend on another control point.
constexpr double kMinHandleMm = 1e-3;

/// The part of the stroke from the tip to the point where the shift has faded out.
struct Zone {
  StrokeData data;
  int segments = 0;           // number of segments in the zone
  std::vector<double> at_mm;  // arc length from the tip to each joint of the zone
};

class TipBend {
 public:
  TipBend(Zone zone, StrokeTip tip) : zone_(std::move(zone)), start_(tip == StrokeTip::kStart) {}

  StrokeData move(Vec by, Vec turn, Point target) && {
    for (int i = 0; i < zone_.segments; ++i) give_direction(i);
    for (int i = 0; i < zone_.segments; ++i) move_joint(i, by, turn);
    point(0) = target;
    return std::move(zone_.data);
  }

 private:
  /// Returns the k-th control point from the tip.
  Point& point(int k) {
    const auto i = static_cast<std::size_t>(k);
    return zone_.data.points[start_ ? i : zone_.data.points.size() - 1 - i];
  }
  /// Returns true if the i-th joint from the tip, i > 0, is smooth.
  [[nodiscard]] bool is_smooth(int i) const {
    const auto k = static_cast<std::size_t>(i);
    const auto& joints = zone_.data.joints;
    return joints[start_ ? k - 1 : joints.size() - k] == JointKind::kSmooth;
  }

  /// Gives a direction to zero-length handles at the tip and at smooth joints before anything
  /// moves.
  void give_direction(int i) {
    if (i > 0 && !is_smooth(i)) return;
    const Point at = point(3 * i);
    Point& out = point(3 * i + 1);
    const Vec away = tangent({{at, out, point(3 * i + 2), point(3 * i + 3)}}, 0.0);
    if (out == at) out = at + kMinHandleMm * away;
    if (i > 0 && point(3 * i - 1) == at) point(3 * i - 1) = at - kMinHandleMm * away;
  }

  void move_joint(int i, Vec by, Vec turn) {
    const double reach = zone_.at_mm.back();
    const double x = zone_.at_mm[static_cast<std::size_t>(i)] / reach;
    const Point was = point(3 * i);
    const double left = 1.0 - x;
    const Point at = was + left * left * ((1.0 + 2.0 * x) * by + (x * reach) * turn);
    const Vec slope = left * ((-6.0 * x / reach) * by + (1.0 - 3.0 * x) * turn);
    Point& out = point(3 * i + 1);
    out = at + (out - was) + distance(out, was) * slope;
    if (i > 0) {
      Point& in = point(3 * i - 1);
      in = at + (in - was) - distance(in, was) * slope;
    }
    point(3 * i) = at;
  }

  Zone zone_;
  bool start_;
};

/// Appends `more`. Requires the first point, width and tone of `more` to be the last ones of
/// `data`.
void append(StrokeData& data, const StrokeData& more) {
  const auto n = static_cast<double>(data.points.size() / 3);
  data.points.insert(data.points.end(), more.points.begin() + 1, more.points.end());
  data.joints.push_back(JointKind::kSmooth);
  data.joints.insert(data.joints.end(), more.joints.begin(), more.joints.end());
  for (std::size_t k = 1; k < more.widths.size(); ++k) {
    const WidthKnot& knot = more.widths[k];
    data.widths.push_back({n + knot.u, knot.width_mm, knot.tone});
  }
}

/// Cuts the stroke at arc length `reach` from the tip, or at the nearest joint if the cut would
/// leave too short a segment. The cut is at least `least` from the tip. Returns nullopt if the
/// stroke is shorter than that.
std::optional<Zone> zone_of(const Stroke& stroke, StrokeTip tip, double reach, double smallest) {
  const int n = stroke.segment_count();
  const bool start = tip == StrokeTip::kStart;
  Zone zone;
  zone.at_mm.push_back(0.0);
  for (int i = 0; i < n; ++i) {
    const Cubic c = stroke.segment(start ? i : n - 1 - i);
    const double before = zone.at_mm.back(), length = arc_length(c, kBendAccuracy);
    if (before + length < reach) {
      zone.at_mm.push_back(before + length);
      continue;
    }
    const double along = start ? reach - before : before + length - reach;
    const double t = parameter_at_length(c, along, kBendAccuracy);
    if (const auto parts = split(stroke, start ? i + t : n - 1 - i + t)) {
      zone.data = parts->first.data();
      append(zone.data, parts->second.data());
      zone.segments = i + 1;
      zone.at_mm.push_back(reach);
      return zone;
    }
    zone.data = stroke.data();
    const bool here = before >= smallest && 2.0 * (reach - before) < length;
    zone.segments = here ? i : i + 1;
    if (!here) zone.at_mm.push_back(before + length);
    return zone;
  }
  return std::nullopt;
}

}  // namespace

Result<Stroke> with_tip_bent(const Stroke& stroke, StrokeTip tip, Point target, double reach_mm,
                             Vec turn) {
  const auto refuse = [](const char* why) { return fail(ErrorCode::kInvalidArgument, why); };
  if (stroke.closed()) return refuse("a closed stroke has no end to move");
  if (!is_finite(target)) return refuse("the position of the end of a stroke is not finite");
  const Vec shift = target - tip_point(stroke, tip);
  if (shift == Vec{} && turn == Vec{}) return stroke;
  auto zone = zone_of(stroke, tip, reach_mm, 2.0 * norm(shift));
  if (!zone || !(2.0 * norm(shift) <= zone->at_mm.back() * (1.0 + 1e-9))) {
    return refuse("the stroke is too short to reach that far");
  }
  return Stroke::create(TipBend(*std::move(zone), tip).move(shift, turn, target));
}

}  // namespace felt
