#include "felt/tools/pull/connected_pull.h"

#include <algorithm>
#include <memory>
#include <set>
#include <utility>

#include "felt/geometry/nearest.h"
#include "felt/tools/pull/nearest_u.h"

namespace felt {
namespace {

bool lies_on(const Stroke& stroke, Point p) {
  for (int i = 0; i < stroke.segment_count(); ++i) {
    if (nearest_within(stroke.segment(i), p, kSharedPointMm * kSharedPointMm)) return true;
  }
  return false;
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

  [[nodiscard]] Point place_of(double u, Point before) const {
    const double changed = before_arc_.length_mm() - first_mm_ - last_mm_;
    const double now = after_arc_.length_mm() - first_mm_ - last_mm_;
    if (changed <= 0.0 || now <= 0.0) return before;
    const double share = std::clamp((before_arc_.length_at(u) - first_mm_) / changed, 0.0, 1.0);
    return after_.position(after_arc_.u_at(first_mm_ + share * now));
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

StrokePtr ConnectedPull::pulled(const BrushPull& brush, StrokePtr stroke, Vec displacement) {
  if (norm(displacement) < 1e-9) return stroke;
  auto result = brush.at(displacement);
  return result ? std::make_shared<const Stroke>(*std::move(result)) : stroke;
}

StrokePtr ConnectedPull::pulled(StrokePtr stroke, double u, Point to) {
  ++work_.brushes;
  return pulled(BrushPull(stroke, u, brush_), stroke, to - stroke->position(u));
}

/// Pulls ends that lie on strokes of locked layers back to their former positions.
StrokePtr ConnectedPull::held(const Leader& leader, StrokePtr after) {
  const Stroke& before = *leader.before;
  const double n = before.segment_count();
  for (const Junction& j : leader.junctions) {
    if (j.editable || before.closed() || (j.u > 0.0 && j.u < n)) continue;
    const double u = j.u <= 0.0 ? 0.0 : after->segment_count();
    after = pulled(after, u, before.position(j.u));
  }
  return after;
}

/// Returns the new positions of the shared points of a stroke. A point at an end moves with the
/// end. A point that is still on the curve stays. Any other point slides along the curve.
std::vector<Point> ConnectedPull::carried(Leader& leader) {
  const Stroke &before = *leader.before, &after = *leader.after;
  const double n = before.segment_count();
  std::optional<Slide> slide;
  std::vector<Point> places;
  for (const Junction& j : leader.junctions) {
    const Point p = before.position(j.u);
    if (!before.closed() && (j.u <= 0.0 || j.u >= n)) {
      places.push_back(after.position(j.u <= 0.0 ? 0.0 : after.segment_count()));
    } else if (lies_on(after, p)) {
      places.push_back(p);
    } else {
      if (!leader.arc) {
        leader.arc.emplace(before, 1e-3);
        ++work_.maps;
      }
      if (!slide) {
        slide.emplace(before, *leader.arc, after);
        ++work_.maps;
      }
      places.push_back(slide->place_of(j.u, p));
    }
  }
  return places;
}

const ConnectedPull::Leader& ConnectedPull::lead(const StrokeChange& change, const Scene& scene) {
  const auto [entry, is_new] = leaders_.try_emplace(change.id);
  Leader& leader = entry->second;
  if (is_new) {
    leader.before = change.before;
    leader.junctions = junctions_of(scene.document, scene.index, change.id, *change.before);
  }
  if (leader.given != change.after) {
    leader.given = change.after;
    leader.after = held(leader, change.after);
    leader.places = carried(leader);
  }
  return leader;
}

ConnectedPull::Follower* ConnectedPull::follower(StrokeId id, const Scene& scene) {
  const auto known = followers_.find(id);
  if (known != followers_.end()) return &known->second;
  if (followers_.size() >= kMaxFollowers) return nullptr;
  return &followers_.try_emplace(id, StrokeReplacement(scene.document, id)).first->second;
}

void ConnectedPull::follow(Follower& follower, std::vector<Pull> pulls) {
  if (follower.pulls == pulls) return;
  follower.pulls = std::move(pulls);
  const StrokePtr& before = follower.place.before();
  const double n = before->segment_count();
  StrokePtr after = before;
  for (const Pull& pull : follower.pulls) {
    if (after == before) {
      if (!follower.brush || follower.brush_u != pull.u) {
        follower.brush.emplace(before, pull.u, brush_);
        follower.brush_u = pull.u;
        ++work_.brushes;
      }
      after = pulled(*follower.brush, before, pull.to - before->position(pull.u));
      continue;
    }
    const double u = pull.u <= 0.0 ? 0.0
                     : pull.u >= n ? after->segment_count()
                                   : nearest_u(*after, before->position(pull.u));
    after = pulled(after, u, pull.to);
  }
  follower.after = std::move(after);
}

void ConnectedPull::complete(Edit& edit, const Scene& scene) {
  std::set<StrokeId> known;
  for (const StrokeChange& c : edit.changes) known.insert(c.id);
  std::size_t begin = 0;
  // Ends, because each round adds followers, and their number is limited.
  while (begin < edit.changes.size()) {
    std::map<StrokeId, std::vector<Pull>> pulls;
    const std::size_t end = edit.changes.size();
    for (; begin < end; ++begin) {
      StrokeChange& change = edit.changes[begin];
      if (!change.before || !change.after || change.before == change.after) continue;
      const Leader& leader = lead(change, scene);
      change.after = leader.after;
      for (std::size_t k = 0; k < leader.junctions.size(); ++k) {
        const Junction& j = leader.junctions[k];
        if (!j.editable || known.contains(j.other)) continue;
        if (distance(leader.places[k], change.before->position(j.u)) < 1e-9) continue;
        pulls[j.other].push_back({j.other_u, leader.places[k]});
      }
    }
    for (auto& [id, places] : pulls) {
      Follower* next = follower(id, scene);
      if (!next) continue;
      known.insert(id);
      follow(*next, std::move(places));
      edit.changes.push_back(next->place.with(next->after, edit.label).changes.front());
    }
  }
}

}  // namespace felt
