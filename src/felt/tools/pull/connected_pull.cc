#include "felt/tools/pull/connected_pull.h"

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

/// Returns the parameter of the point of a stroke that is nearest to p, or nullopt if it is farther
/// away than kSharedPointMm.
std::optional<double> u_near(const Stroke& stroke, Point p) {
  std::optional<double> found;
  double nearest = kSharedPointMm * kSharedPointMm;
  for (int i = 0; i < stroke.segment_count(); ++i) {
    const auto near = nearest_within(stroke.segment(i), p, nearest);
    if (!near) continue;
    found = i + near->t;
    nearest = near->distance_squared;
  }
  return found;
}

bool is_end(const Stroke& stroke, double u) {
  return !stroke.closed() && (u <= 0.0 || u >= stroke.segment_count());
}

/// Returns true if u is on the ink next to one of `us`, except number k.
bool is_near_other(const Stroke& stroke, const std::vector<double>& us, std::size_t k, double u) {
  const Point p = stroke.position(u);
  for (std::size_t i = 0; i < us.size(); ++i) {
    if (i != k && distance(stroke.position(us[i]), p) < 4.0 * kMinSegmentMm) return true;
  }
  return false;
}

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

/// Returns the parameters, after a change, of points of a stroke. An end stays an end. A point that
/// is still on the curve stays. Any other point slides along the curve.
std::vector<double> ConnectedPull::carried(Line& line, const Stroke& after,
                                           const std::vector<double>& us) {
  const Stroke& before = *line.before;
  if (&before == &after) return us;
  std::optional<Slide> slide;
  std::vector<double> now;
  for (const double u : us) {
    if (is_end(before, u)) {
      now.push_back(u <= 0.0 ? 0.0 : after.segment_count());
      continue;
    }
    if (const auto on = u_near(after, before.position(u))) {
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

ConnectedPull::Line& ConnectedPull::line(StrokeId id, const StrokePtr& before, const Scene& scene) {
  const auto [entry, is_new] = lines_.try_emplace(id);
  Line& line = entry->second;
  if (!is_new) return line;
  line.before = before;
  for (const Junction& j : junctions_of(scene.document, scene.index, id, *before)) {
    const Stroke& other = *scene.document.find(j.other);
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

/// Moves the shared points of a stroke to where the other strokes are.
StrokePtr ConnectedPull::shaped(Line& line) {
  std::vector<double> us;
  for (const PointMove& tie : line.ties) us.push_back(tie.u);
  us = carried(line, *line.given, us);
  std::vector<PointMove> moves;
  bool holds = true;
  for (std::size_t k = 0; k < us.size(); ++k) {
    const Point to = line.ties[k].to;
    double u = us[k];
    // Strokes that a gesture changed together may still be joined, at another point of this one.
    const bool keeps = line.given == line.before || is_end(*line.given, u);
    const auto on = keeps ? std::nullopt : u_near(*line.given, to);
    if (on && !is_near_other(*line.given, us, k, *on)) u = *on;
    holds = holds && distance(line.given->position(u), to) <= kStillMm;
    moves.push_back({u, to});
  }
  if (holds) return line.given;
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

void ConnectedPull::place(Line& line, const StrokePtr& given, std::vector<Tie> ties) {
  std::vector<PointMove> all;
  for (const Link& link : line.links) {
    if (link.is_held) all.push_back({link.u, link.start});
  }
  // In a heap of lines an end may lie near several lines. It stays on the nearest one.
  std::stable_sort(ties.begin(), ties.end(),
                   [](const Tie& a, const Tie& b) { return a.gap_mm < b.gap_mm; });
  for (const Tie& tie : ties) {
    const bool known = std::any_of(all.begin(), all.end(), [&](const PointMove& k) {
      return std::fabs(k.u - tie.move.u) < 1e-9;
    });
    if (!known) all.push_back(tie.move);
  }
  if (line.after && line.given == given && line.ties == all) return;
  line.given = given;
  line.ties = std::move(all);
  line.after = shaped(line);
  std::vector<double> us;
  for (const Link& link : line.links) us.push_back(link.u);
  line.places.clear();
  for (const double u : carried(line, *line.after, us)) {
    line.places.push_back(line.after->position(u));
  }
}

/// Returns where a stroke that has been placed takes a point of another one. `waiting` is the other
/// stroke if the gesture has changed it too.
ConnectedPull::Tie ConnectedPull::tie_at(const Line& line, std::size_t i, const Stroke* waiting) {
  const Link& link = line.links[i];
  Tie tie{{link.other_u, line.places[i] + link.offset}, norm(link.offset)};
  // The gesture may have moved the end of the other stroke along this one.
  if (waiting && link.is_other_end && !is_end(*line.before, link.u)) {
    const Point tip = end_of(*waiting, link.other_u);
    if (u_near(*line.after, tip - link.offset)) tie.move.to = tip;
  }
  return tie;
}

void ConnectedPull::complete(Edit& edit, const Scene& scene) {
  std::map<StrokeId, std::vector<Tie>> ties;
  std::map<StrokeId, StrokePtr> waiting;  // the gesture's own strokes that have no place yet
  std::set<StrokeId> queued, placed;
  for (const StrokeChange& c : edit.changes) {
    queued.insert(c.id);
    if (c.after) waiting.emplace(c.id, c.after);
  }
  const std::size_t own = edit.changes.size();
  std::vector<std::size_t> order(own);
  std::iota(order.begin(), order.end(), 0U);
  // Ends, because each round adds followers, and their number is limited.
  for (std::size_t k = 0; k < order.size();) {
    std::set<StrokeId> next;
    for (const std::size_t end = order.size(); k < end; ++k) {
      const bool is_own = order[k] < own;
      StrokeChange& change = edit.changes[order[k]];
      placed.insert(change.id);
      waiting.erase(change.id);
      if (!change.before || !change.after) continue;
      Line& now = line(change.id, change.before, scene);
      place(now, is_own ? change.after : now.before, std::move(ties[change.id]));
      change.after = now.after;
      for (std::size_t i = 0; i < now.links.size(); ++i) {
        const Link& link = now.links[i];
        if (link.is_held || placed.contains(link.other)) continue;
        const auto other = waiting.find(link.other);
        ties[link.other].push_back(
            tie_at(now, i, other != waiting.end() ? other->second.get() : nullptr));
        const bool moves = distance(now.places[i], link.start) > kStillMm;
        if (moves && !queued.contains(link.other)) next.insert(link.other);
      }
    }
    for (const StrokeId id : next) {
      Line* const follows = follower(id, scene);
      if (!follows) continue;
      queued.insert(id);
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
