#include "felt/tools/connected_pull.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>
#include <set>
#include <utility>

#include "felt/geometry/nearest.h"
#include "felt/tools/junctions.h"

namespace felt {
namespace {

/// Shared points that are at most this far from where they belong stay.
constexpr double kStillMm = 2e-6;

/// Strokes of at most this many segments are searched without a tree.
constexpr int kNoTreeSegments = 16;

bool is_end(const Stroke& stroke, double u) {
  return !stroke.closed() && (u <= 0.0 || u >= stroke.segment_count());
}

/// Parameters of points of a stroke, in order.
class OrderedPoints {
 public:
  OrderedPoints(const Stroke& stroke, const std::vector<double>& us) : stroke_(stroke) {
    for (std::size_t k = 0; k < us.size(); ++k) points_.emplace_back(us[k], k);
    std::sort(points_.begin(), points_.end());
  }

  /// Returns true if u is on the ink next to one of the points, except number k.
  [[nodiscard]] bool is_near_other(std::size_t k, double u, int& work) const {
    constexpr std::size_t kAround = 2;  // on each side, because number k may be one of them
    const Point p = stroke_.position(u);
    const auto next = std::lower_bound(points_.begin(), points_.end(), std::pair(u, std::size_t{}));
    const std::size_t count = points_.size();
    const auto first = static_cast<std::size_t>(next - points_.begin()) + count - kAround % count;
    for (std::size_t i = 0; i < std::min(count, 2 * kAround); ++i) {
      ++work;
      const auto& [other_u, other] = points_[(first + i) % count];
      if (other != k && distance(stroke_.position(other_u), p) < 4.0 * kMinSegmentMm) return true;
    }
    return false;
  }

 private:
  const Stroke& stroke_;
  std::vector<std::pair<double, std::size_t>> points_;
};

/// Returns the position of an end after a change; u is that before the change.
Point end_of(const Stroke& after, double u) {
  return after.position(u <= 0.0 ? 0.0 : after.segment_count());
}

/// Maps points of a stroke after a part between its ends has changed. Each point keeps its relative
/// arc length within that part.
class Slide {
 public:
  Slide(const Stroke& before, const ArcMap& before_arc, const Stroke& after)
      : before_arc_(before_arc), after_(after), after_arc_(after, 1e-3) {
    first_mm_ = same_length_mm(before, false);
    last_mm_ = same_length_mm(before, true);
  }

  [[nodiscard]] double u_of(double before_u) const {
    const double changed = before_arc_.length_mm() - first_mm_ - last_mm_;
    const double now = after_arc_.length_mm() - first_mm_ - last_mm_;
    const double s = before_arc_.length_at(before_u);
    if (changed <= 0.0 || now <= 0.0) return after_arc_.u_at(s);
    const double share = std::clamp((s - first_mm_) / changed, 0.0, 1.0);
    return after_arc_.u_at(first_mm_ + share * now);
  }

 private:
  /// Returns the length from the start (or the end) over which both strokes are equal. Accuracy:
  /// 1/64 of the length.
  [[nodiscard]] double same_length_mm(const Stroke& before, bool from_end) const {
    constexpr int kSteps = 64;
    const double length = before_arc_.length_mm(), after_length = after_arc_.length_mm();
    double same = 0.0;
    for (int k = 0; k <= kSteps; ++k) {
      const double s = length * k / kSteps;
      if (s > after_length) break;
      const Point a = before.position(before_arc_.u_at(from_end ? length - s : s));
      const Point b = after_.position(after_arc_.u_at(from_end ? after_length - s : s));
      if (distance(a, b) > kSharedPointMm) break;
      same = s;
    }
    return same;
  }

  const ArcMap& before_arc_;
  const Stroke& after_;
  ArcMap after_arc_;
  double first_mm_ = 0.0, last_mm_ = 0.0;
};

}  // namespace

const SegmentBvh& NearCurve::tree(int& work) {
  if (tree_.size() > 0) return tree_;
  const int n = stroke_->segment_count();
  std::vector<BvhSegment> segments;
  segments.reserve(static_cast<std::size_t>(n));
  for (int i = 0; i < n; ++i) {
    segments.push_back({stroke_->segment(i), {0, static_cast<std::uint32_t>(i)}});
  }
  tree_.build(segments);
  work += n;
  return tree_;
}

std::optional<double> NearCurve::u_near(Point p, int& work) {
  const int n = stroke_->segment_count();
  if (n > kNoTreeSegments) {
    constexpr BvhWorkCap kNoCap{1 << 24, 1 << 24};
    const auto hit = tree(work).nearest({.point = p, .radius_mm = kSharedPointMm, .cap = kNoCap});
    work += hit.used.nodes + hit.used.pieces;
    if (!hit) return std::nullopt;
    return hit.ref.segment + hit.nearest.t;
  }
  std::optional<double> found;
  double nearest = kSharedPointMm * kSharedPointMm;
  for (int i = 0; i < n; ++i) {
    const auto near = nearest_within(stroke_->segment(i), p, nearest);
    if (!near) continue;
    found = i + near->t;
    nearest = near->distance_squared;
  }
  work += n;
  return found;
}

/// Returns the parameters, after a change, of points of a stroke. An end stays an end. A point that
/// is still on the curve stays. Any other point slides along the curve.
std::vector<double> ConnectedPull::carried(Line& line, NearCurve& curve,
                                           const std::vector<double>& us) {
  const Stroke &before = *line.before, &after = *curve.stroke();
  if (&before == &after) return us;
  std::optional<Slide> slide;
  std::vector<double> now;
  for (const double u : us) {
    if (is_end(before, u)) {
      now.push_back(u <= 0.0 ? 0.0 : after.segment_count());
      continue;
    }
    if (const auto on = curve.u_near(before.position(u), work_.looks)) {
      now.push_back(*on);
      continue;
    }
    if (!line.arc) {
      line.arc.emplace(before, 1e-3);
      ++work_.maps;
    }
    if (!slide) {
      slide.emplace(before, *line.arc, after);
      ++work_.maps;
    }
    now.push_back(slide->u_of(u));
  }
  return now;
}

bool ConnectedPull::is_released(StrokeId id, const Stroke& stroke, double u, StrokeId other) const {
  if (!is_end(stroke, u)) return false;
  const TipId tip{id, u <= 0.0 ? StrokeTip::kStart : StrokeTip::kEnd};
  return released_.contains(tip) || released_from_.contains({tip, other});
}

ConnectedPull::Line& ConnectedPull::line(StrokeId id, const StrokePtr& before, const Scene& scene) {
  const auto [entry, is_new] = lines_.try_emplace(id);
  Line& line = entry->second;
  if (!is_new) return line;
  line.before = before;
  for (const Junction& j : junctions_of(scene.document, scene.index, id, *before)) {
    const Stroke& other = *scene.document.find(j.other);
    if (is_released(id, *before, j.u, j.other)) continue;
    if (is_released(j.other, other, j.other_u, id)) continue;
    const Point here = before->position(j.u);
    line.links.push_back({j.u, j.other, j.other_u, here, other.position(j.other_u) - here,
                          is_end(other, j.other_u), !j.editable});
  }
  return line;
}

ConnectedPull::Line* ConnectedPull::follower(StrokeId id, const Scene& scene) {
  const auto known = lines_.find(id);
  if (known != lines_.end() && known->second.follows) return &known->second;
  if (followers_ >= kMaxFollowers) return nullptr;
  ++followers_;
  StrokeReplacement place(scene.document, id);
  Line& added = line(id, place.before(), scene);
  added.follows = std::move(place);
  return &added;
}

/// Returns the points of a stroke that must move; empty if all are where they belong.
std::vector<PointMove> ConnectedPull::moves_of(Line& line, NearCurve& given) {
  const Stroke& stroke = *given.stroke();
  const bool is_changed = line.given != line.before;
  std::vector<double> us;
  for (const Tie& tie : line.ties) us.push_back(tie.move.u);
  us = carried(line, given, us);
  const OrderedPoints points(stroke, us);
  std::vector<PointMove> moves;
  bool holds = true;
  for (std::size_t k = 0; k < us.size(); ++k) {
    const auto& [move, offset] = line.ties[k];
    Point to = move.to;
    double u = us[k];
    // Strokes that a gesture changed together may still be joined, at another point of this one.
    const bool keeps = !is_changed || is_end(stroke, u);
    const auto on = keeps ? std::nullopt : given.u_near(to, work_.looks);
    if (on && !points.is_near_other(k, *on, work_.looks)) u = *on;
    // Points that are not farther apart than at the touch need not move.
    const Point here = stroke.position(u);
    if (is_changed && distance(here, to - offset) <= norm(offset)) to = here;
    holds = holds && distance(here, to) <= kStillMm;
    moves.push_back({u, to});
  }
  if (holds) moves.clear();
  return moves;
}

/// Moves the shared points of a stroke to where the other strokes are.
StrokePtr ConnectedPull::shaped(Line& line) {
  NearCurve given(line.given);
  const std::vector<PointMove> moves = moves_of(line, given);
  if (moves.empty()) return line.given;
  Result<Stroke> moved = fail(ErrorCode::kNotFound, "");
  if (moves.size() == 1 && line.given == line.before) {
    if (!line.brush || line.brush_u != moves.front().u) {
      line.brush.emplace(line.before, moves.front().u, brush_);
      line.brush_u = moves.front().u;
      ++work_.brushes;
    }
    moved = line.brush->at(moves.front().to - line.before->position(moves.front().u));
  } else {
    ++work_.brushes;
    moved = with_points_moved(line.given, moves, brush_);
  }
  return moved ? std::make_shared<const Stroke>(*std::move(moved)) : line.given;
}

/// Returns the ties that a stroke must hold: those to locked strokes, and one for each of its other
/// shared points.
std::vector<ConnectedPull::Tie> ConnectedPull::held(const Line& line, std::vector<Tie> ties) {
  std::vector<Tie> all;
  for (const Link& link : line.links) {
    if (link.is_held) all.push_back({{link.u, link.start}, {}});
  }
  // In a heap of lines an end may lie near several lines. It stays on the nearest one.
  std::stable_sort(ties.begin(), ties.end(),
                   [](const Tie& a, const Tie& b) { return norm(a.offset) < norm(b.offset); });
  std::set<double> known;
  for (const Tie& tie : all) known.insert(tie.move.u);
  for (const Tie& tie : ties) {
    constexpr double kSameU = 1e-9;
    const auto near = known.lower_bound(tie.move.u - kSameU);
    ++work_.looks;
    if (near != known.end() && *near < tie.move.u + kSameU) continue;
    known.insert(tie.move.u);
    all.push_back(tie);
  }
  return all;
}

void ConnectedPull::place(Line& line, const StrokePtr& given, std::vector<Tie> all) {
  if (line.placed && line.given == given && line.ties == all) return;
  line.given = given;
  line.ties = std::move(all);
  line.placed.emplace(shaped(line));
  std::vector<double> us;
  for (const Link& link : line.links) us.push_back(link.u);
  line.places.clear();
  for (const double u : carried(line, *line.placed, us)) {
    line.places.push_back(line.placed->stroke()->position(u));
  }
}

/// Returns where a stroke that has been placed takes a point of another one. `waiting` is the other
/// stroke if the gesture has changed it too.
ConnectedPull::Tie ConnectedPull::tie_at(Line& line, std::size_t i, const Stroke* waiting) {
  const Link& link = line.links[i];
  Tie tie{{link.other_u, line.places[i] + link.offset}, link.offset};
  // The gesture may have moved the end of the other stroke along this one.
  if (waiting && link.is_other_end && !is_end(*line.before, link.u)) {
    const Point tip = end_of(*waiting, link.other_u);
    if (line.placed->u_near(tip - link.offset, work_.looks)) tie.move.to = tip;
  }
  return tie;
}

/// Places a stroke of the edit, and passes its shared points on to the strokes that have no place.
void ConnectedPull::place_change(StrokeChange& change, bool is_own, Spread& spread,
                                 const Scene& scene) {
  spread.placed.insert(change.id);
  spread.waiting.erase(change.id);
  if (!change.before || !change.after) return;
  Line& now = line(change.id, change.before, scene);
  const bool is_rigid = is_own && rigid_.contains(change.id);
  std::vector<Tie> ties = std::move(spread.ties[change.id]);
  place(now, is_own ? change.after : now.before,
        is_rigid ? std::vector<Tie>() : held(now, std::move(ties)));
  change.after = now.placed->stroke();
  for (std::size_t i = 0; i < now.links.size(); ++i) {
    const Link& link = now.links[i];
    if (link.is_held || spread.placed.contains(link.other)) continue;
    const auto other = spread.waiting.find(link.other);
    const Stroke* waiting = other != spread.waiting.end() ? other->second.get() : nullptr;
    spread.ties[link.other].push_back(tie_at(now, i, waiting));
    const bool moves = distance(now.places[i], link.start) > kStillMm;
    if (moves && !spread.queued.contains(link.other)) spread.next.insert(link.other);
  }
}

void ConnectedPull::complete(Edit& edit, const Scene& scene) {
  Spread spread;
  for (const StrokeChange& c : edit.changes) {
    spread.queued.insert(c.id);
    if (c.after) spread.waiting.emplace(c.id, c.after);
  }
  const std::size_t own = edit.changes.size();
  std::vector<std::size_t> order(own);
  std::iota(order.begin(), order.end(), 0U);
  // Those that keep their shape come first, because the others can go where they are.
  std::stable_partition(order.begin(), order.end(),
                        [&](std::size_t i) { return rigid_.contains(edit.changes[i].id); });
  // Ends, because each round adds followers, and their number is limited.
  for (std::size_t k = 0; k < order.size();) {
    for (const std::size_t end = order.size(); k < end; ++k) {
      place_change(edit.changes[order[k]], order[k] < own, spread, scene);
    }
    for (const StrokeId id : std::exchange(spread.next, {})) {
      Line* const follows = follower(id, scene);
      if (!follows) continue;
      spread.queued.insert(id);
      order.push_back(edit.changes.size());
      edit.changes.push_back(follows->follows->with(follows->before, edit.label).changes.front());
    }
  }
  const auto followers = edit.changes.begin() + static_cast<std::ptrdiff_t>(own);
  edit.changes.erase(std::remove_if(followers, edit.changes.end(),
                                    [](const StrokeChange& c) { return c.before == c.after; }),
                     edit.changes.end());
}

}  // namespace felt
