#include "felt/fill/tip_links.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "felt/geometry/bvh.h"
#include "felt/geometry/intersect.h"
#include "felt/geometry/nearest.h"

namespace felt {
namespace {

constexpr double kTinyMm = 1e-6;

double tip_u(const Stroke& stroke, StrokeTip tip) {
  return tip == StrokeTip::kStart ? 0.0 : stroke.segment_count();
}

LinkEnd end_at(StrokeId id, const Stroke& stroke, StrokeTip tip) {
  return {id, tip_u(stroke, tip), tip_point(stroke, tip)};
}

Rect box_of(Point a, Point b) {
  Rect box;
  box.extend(a);
  box.extend(b);
  return box;
}

/// Returns how far from the tip, in u, the stroke first leaves the circle around the tip, or
/// nullopt if it never does.
std::optional<double> leaves_circle_at(const MeetingLine& line, StrokeTip tip, double radius_mm) {
  constexpr int kSteps = 32;
  const Point centre = tip_point(*line.stroke, tip);
  const int n = line.stroke->segment_count();
  for (int k = 1; k <= n * kSteps; ++k) {
    const double away = static_cast<double>(k) / kSteps;
    const double u = tip == StrokeTip::kStart ? away : n - away;
    if (distance(line.stroke->position(u), centre) > radius_mm) return away;
  }
  return std::nullopt;
}

/// The part [from, to] of a stroke in u.
struct Span {
  double from = 0.0;
  double to = 0.0;
};

std::optional<LinkEnd> nearest_on(StrokeId id, const MeetingLine& line, Span span, Point p,
                                  double radius_mm) {
  std::optional<LinkEnd> best;
  double limit = radius_mm * radius_mm;
  for (std::size_t i = 0; i < line.segments.size(); ++i) {
    const auto start = static_cast<double>(i);
    const double t0 = std::max(span.from - start, 0.0), t1 = std::min(span.to - start, 1.0);
    if (t0 >= t1 || distance_squared(line.boxes[i], p) > limit) continue;
    const auto hit = nearest_within(sub_segment(line.segments[i], t0, t1), p, limit);
    if (!hit || (best && hit->distance_squared >= limit)) continue;
    limit = hit->distance_squared;
    best = LinkEnd{id, start + t0 + hit->t * (t1 - t0), hit->point};
  }
  return best;
}

}  // namespace

struct TipLinker::Tip {
  StrokeId id;
  StrokeTip tip;
  const MeetingLine& line;
  LinkEnd end;
  double half_mm;
};

std::vector<TipLink> TipLinker::links(StrokeId id, StrokeTip tip) const {
  std::vector<TipLink> links;
  const MeetingLine* line = meetings_.find(id);
  if (!line || line->stroke->closed()) return links;
  const LinkEnd end = end_at(id, *line->stroke, tip);
  const Tip from{id, tip, *line, end, 0.5 * line->stroke->width_mm(end.u)};
  const bool met = find_touches(from, links);
  if (met || !links.empty() || !(max_gap_mm_ > 0.0)) return links;
  if (auto found = bridge(from)) links.push_back(*found);
  return links;
}

/// Adds the touches with the ends of other strokes, and the shortest one with another point of a
/// stroke. Returns true if the end meets a stroke.
bool TipLinker::find_touches(const Tip& tip, std::vector<TipLink>& links) const {
  bool met = false;
  std::optional<TipLink> shortest;
  const Rect near =
      box_of(tip.end.point, tip.end.point).inflated(tip.half_mm + meetings_.widest_half_mm());
  for (const StrokeId id : meetings_.lines_in(near)) {
    const MeetingLine& line = *meetings_.find(id);
    const double reach = tip.half_mm + line.half_mm;
    if (distance_squared(line.box, tip.end.point) > reach * reach) continue;
    const auto found = touch(tip, id, line, met);
    if (!found || is_blocked(*found)) continue;
    const double n = line.stroke->segment_count();
    const bool is_tip = !line.stroke->closed() && (found->to.u == 0.0 || found->to.u == n);
    if (is_tip) {
      links.push_back(*found);
    } else if (!shortest || found->length_mm < shortest->length_mm) {
      shortest = found;
    }
  }
  if (shortest) links.push_back(*shortest);
  return met;
}

std::optional<TipLink> TipLinker::touch(const Tip& tip, StrokeId id, const MeetingLine& line,
                                        bool& met) const {
  const Point p = tip.end.point;
  const double reach = tip.half_mm + line.half_mm;
  Span span{0.0, static_cast<double>(line.stroke->segment_count())};
  if (id == tip.id) {
    const auto away = leaves_circle_at(line, tip.tip, 2.0 * reach);
    if (!away) return std::nullopt;
    (tip.tip == StrokeTip::kStart ? span.from : span.to) =
        tip.tip == StrokeTip::kStart ? *away : span.to - *away;
  }
  auto foot = nearest_on(id, line, span, p, reach);
  if (!foot) return std::nullopt;
  const double touching = tip.half_mm + 0.5 * line.stroke->width_mm(foot->u);
  if (distance(foot->point, p) > touching) return std::nullopt;
  for (const Meeting& m : meetings_.between(tip.id, id)) {
    if (distance(m.point, p) > 2.0 * touching) continue;
    met = true;
    return std::nullopt;
  }
  if (!line.stroke->closed()) {
    for (const StrokeTip other : {StrokeTip::kStart, StrokeTip::kEnd}) {
      if (id == tip.id && other == tip.tip) continue;
      const LinkEnd end = end_at(id, *line.stroke, other);
      if (distance(end.point, p) <= touching) foot = end;
    }
  }
  return TipLink{tip.end, *foot, std::nullopt, distance(p, foot->point), true};
}

std::optional<TipLink> TipLinker::bridge(const Tip& tip) const {
  std::optional<TipLink> best = extension(tip);
  const Rect near = box_of(tip.end.point, tip.end.point).inflated(max_gap_mm_);
  for (const StrokeId id : meetings_.lines_in(near)) {
    const MeetingLine& line = *meetings_.find(id);
    if (line.stroke->closed()) continue;
    for (const StrokeTip other : {StrokeTip::kStart, StrokeTip::kEnd}) {
      if (id == tip.id && other == tip.tip) continue;
      const auto found = to_tip(tip, id, line, other);
      if (!found || (best && best->length_mm <= found->length_mm)) continue;
      if (!is_blocked(*found)) best = found;
    }
  }
  return best;
}

/// Extends the end along its tangent up to the first stroke.
std::optional<TipLink> TipLinker::extension(const Tip& tip) const {
  const Point p = tip.end.point;
  const Vec direction = tip_direction(*tip.line.stroke, tip.tip);
  if (direction == Vec{}) return std::nullopt;
  const Point far = p + max_gap_mm_ * direction;
  const Cubic ray = straight(p, far);
  const Rect box = box_of(p, far);
  std::optional<TipLink> best;
  for (const StrokeId id : meetings_.lines_in(box)) {
    const MeetingLine& line = *meetings_.find(id);
    for (std::size_t i = 0; i < line.segments.size(); ++i) {
      if (!line.boxes[i].intersects(box)) continue;
      for (const Crossing& c : intersections(ray, line.segments[i])) {
        const double length = distance(p, c.point);
        if (length <= kTinyMm || (best && best->length_mm <= length)) continue;
        const LinkEnd to{id, static_cast<double>(i) + c.t2, c.point};
        best = TipLink{tip.end, to, std::nullopt, length, false};
      }
    }
  }
  return best;
}

/// Joins two ends that face each other, if they are near enough.
std::optional<TipLink> TipLinker::to_tip(const Tip& tip, StrokeId id, const MeetingLine& line,
                                         StrokeTip other) const {
  const LinkEnd to = end_at(id, *line.stroke, other);
  const Vec gap = to.point - tip.end.point;
  const double length = norm(gap);
  if (!(length <= max_gap_mm_) || length <= kTinyMm) return std::nullopt;
  const Vec d = tip_direction(*tip.line.stroke, tip.tip), e = tip_direction(*line.stroke, other);
  TipLink link{tip.end, to, std::nullopt, length, false};
  const double turn = cross(d, e);
  if (std::fabs(turn) > 1e-3) {
    const double s = cross(gap, e) / turn, t = cross(gap, d) / turn;  // both along the extensions
    const bool near = s <= max_gap_mm_ && t <= max_gap_mm_ && s + t <= 3.0 * length;
    if (s > kTinyMm && t > kTinyMm && near) {
      link.corner = tip.end.point + s * d;
      return link;
    }
  }
  if (dot(d, gap) < 0.0 || dot(e, gap) > 0.0) return std::nullopt;
  return link;
}

/// Returns true if a stroke crosses the link between its ends.
bool TipLinker::is_blocked(const TipLink& link) const {
  const Point middle = link.corner.value_or(link.to.point);
  const Cubic parts[] = {straight(link.from.point, middle), straight(middle, link.to.point)};
  for (int k = 0; k < (link.corner ? 2 : 1); ++k) {
    const Rect box = control_bounds(parts[k]);
    for (const StrokeId id : meetings_.lines_in(box)) {
      const MeetingLine& line = *meetings_.find(id);
      for (std::size_t i = 0; i < line.segments.size(); ++i) {
        if (!line.boxes[i].intersects(box)) continue;
        for (const Crossing& c : intersections(parts[k], line.segments[i])) {
          const bool at_end = distance(c.point, link.from.point) <= kTinyMm ||
                              distance(c.point, link.to.point) <= kTinyMm;
          if (!at_end) return true;
        }
      }
    }
  }
  return false;
}

void TipLinks::forget(std::span<const Rect> areas) {
  std::vector<BvhSegment> diagonals;  // a diagonal has the same box as its area
  for (const Rect& area : areas) {
    diagonals.push_back({straight({area.x0, area.y0}, {area.x1, area.y1}), {}});
  }
  SegmentBvh tree;
  tree.build(diagonals);
  for (auto tip = known_.begin(); tip != known_.end();) {
    bool changed = false;
    tree.for_each_in(tip->second.reach, [&](std::uint32_t) { changed = true; });
    tip = changed ? known_.erase(tip) : std::next(tip);
  }
}

std::vector<TipLink> TipLinks::links(const LineMeetings& meetings) {
  const TipLinker linker(meetings, max_gap_mm_);
  std::vector<TipLink> all;
  for (const auto& [id, line] : meetings.lines()) {
    if (line.stroke->closed()) continue;
    for (const StrokeTip tip : {StrokeTip::kStart, StrokeTip::kEnd}) {
      const auto [entry, is_new] = known_.try_emplace({id, tip});
      if (is_new) {
        const Point p = tip_point(*line.stroke, tip);
        // The areas of TipLinks::forget() contain the other stroke's width, but not our own.
        const double own = line.stroke->width_mm(tip_u(*line.stroke, tip));
        entry->second = {box_of(p, p).inflated(std::max(max_gap_mm_, own)), linker.links(id, tip)};
      }
      all.insert(all.end(), entry->second.links.begin(), entry->second.links.end());
    }
  }
  std::stable_sort(all.begin(), all.end(), [](const TipLink& a, const TipLink& b) {
    return std::tuple(!a.touch, a.length_mm) < std::tuple(!b.touch, b.length_mm);
  });
  // Joins ends like a minimum spanning tree (Kruskal): an end that is reached already needs no
  // other link. Two ends that found each other give one link.
  std::map<std::pair<StrokeId, double>, std::size_t> group_of;
  std::vector<std::size_t> parent;
  const auto root_of = [&](const LinkEnd& end) {
    const auto [entry, is_new] = group_of.try_emplace({end.stroke, end.u}, parent.size());
    if (is_new) parent.push_back(parent.size());
    std::size_t i = entry->second;
    while (parent[i] != i) i = parent[i] = parent[parent[i]];
    return i;
  };
  std::erase_if(all, [&](const TipLink& link) {
    const std::size_t a = root_of(link.from), b = root_of(link.to);
    parent[a] = b;
    return a == b;
  });
  return all;
}

}  // namespace felt
