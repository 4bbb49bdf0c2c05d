#include "felt/tools/pencil/snap_rules.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "felt/base/constants.h"
#include "felt/document/stroke_index.h"
#include "felt/geometry/intersect.h"

namespace felt::snap_rules {
namespace {

/// Maximum number of ends that are checked around one end. With more ends nearby, the end is
/// crowded in any case.
constexpr std::size_t kMaxNeighbours = 8;
/// Hits on one stroke within kJointMm of each other count as one hit, at the joint of two segments.
constexpr double kJointMm = 0.01;

/// Calls visit(StrokeId, curve, Crossing) for each point where the chord meets a stroke.
template <class Visit>
void for_each_meeting(const Scene& scene, Point a, Point b, Visit visit) {
  Rect area;
  area.extend(a);
  area.extend(b);
  const Cubic chord = straight(a, b);
  scene.index.for_each_segment_in(area, [&](StrokeId id, int segment) {
    const StrokePtr stroke = scene.document.find(id);
    if (!stroke) return;
    const Cubic curve = stroke->segment(segment);
    for (const Crossing& crossing : intersections(chord, curve)) visit(id, curve, crossing);
  });
}

bool share_an_end(const Scene& scene, StrokeId a, StrokeId b) {
  const StrokePtr one = scene.document.find(a), other = scene.document.find(b);
  if (!one || !other) return false;
  for (const StrokeTip i : {StrokeTip::kStart, StrokeTip::kEnd}) {
    for (const StrokeTip k : {StrokeTip::kStart, StrokeTip::kEnd}) {
      if (distance(tip_point(*one, i), tip_point(*other, k)) <= kSameMm) return true;
    }
  }
  return false;
}

}  // namespace

bool is_dot(const Stroke& stroke) noexcept {
  Rect box;
  for (const Point& p : stroke.data().points) box.extend(p);
  return std::hypot(box.width(), box.height()) < kDotMm;
}

Vec inward_direction(const Stroke& stroke, StrokeTip tip) noexcept {
  constexpr int kSteps = 16;
  const bool start = tip == StrokeTip::kStart;
  const int n = stroke.segment_count();
  const Point at = tip_point(stroke, tip);
  for (int i = 0; i < n; ++i) {
    const Cubic c = stroke.segment(start ? i : n - 1 - i);
    for (int k = 1; k <= kSteps; ++k) {
      const double t = static_cast<double>(k) / kSteps;
      const Vec way = evaluate(c, start ? t : 1.0 - t) - at;
      if (norm(way) >= kInwardMm) return normalized(way);
    }
  }
  return -tip_direction(stroke, tip);
}

bool turns_back(const Stroke& stroke, StrokeTip tip, Vec heading, double gap_mm) noexcept {
  const double deg = angle_between(heading, inward_direction(stroke, tip)) * kDegPerRad;
  return deg > kFoldDeg || (deg > kSharpDeg && gap_mm > kSharpRadiusMm);
}

bool is_crowded(const Scene& scene, const TipHit& tip, StrokeId friend_stroke) {
  std::array<TipId, kMaxNeighbours> seen;
  std::size_t count = 0;
  while (count < kMaxNeighbours) {
    const auto hit =
        scene.index.nearest_tip(scene.document, tip.point, kCrowdMm, std::span(seen).first(count));
    if (!hit) return false;
    seen[count++] = hit->id;
    const StrokeId other = hit->id.stroke;
    if (hit->distance_mm <= kSameMm || other == tip.id.stroke || other == friend_stroke) continue;
    if (!share_an_end(scene, tip.id.stroke, other)) return true;
  }
  return true;
}

std::optional<RayHit> first_hit(const Scene& scene, Point from, Vec direction, double length_mm) {
  std::optional<RayHit> first;
  int hits = 0;
  for_each_meeting(scene, from, from + length_mm * direction,
                   [&](StrokeId id, const Cubic& curve, const Crossing& crossing) {
                     const Point at = evaluate(curve, crossing.t2);
                     if (first && first->stroke == id && distance(first->point, at) < kJointMm)
                       return;
                     ++hits;
                     const double away = distance(from, at);
                     if (first && away >= first->distance_mm) return;
                     const double deg =
                         angle_between(direction, tangent(curve, crossing.t2)) * kDegPerRad;
                     first = RayHit{id, at, away, std::min(deg, 180.0 - deg)};
                   });
  if (first) first->hits = hits;
  return first;
}

bool append_crossed(const Scene& scene, Point a, Point b, std::vector<Crossed>& crossed) {
  bool any = false;
  for_each_meeting(scene, a, b, [&](StrokeId id, const Cubic&, const Crossing& crossing) {
    any = true;
    const auto known = std::find_if(crossed.begin(), crossed.end(),
                                    [&](const Crossed& c) { return c.stroke == id; });
    if (known == crossed.end()) {
      crossed.push_back({id, crossing.point, crossing.point});
    } else {
      known->last = crossing.point;
    }
  });
  return any;
}

bool is_drawn_over(const std::vector<Crossed>& crossed, StrokeId stroke, Point tip) noexcept {
  return std::any_of(crossed.begin(), crossed.end(), [&](const Crossed& c) {
    return c.stroke == stroke &&
           std::max(distance(c.first, tip), distance(c.last, tip)) > kCornerMm;
  });
}

}  // namespace felt::snap_rules
