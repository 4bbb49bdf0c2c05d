#include "felt/tools/pull/connected_pull.h"

#include <algorithm>
#include <memory>
#include <set>
#include <utility>

#include "felt/geometry/nearest.h"
#include "felt/stroke/arc_map.h"
#include "felt/tools/pull/brush_pull.h"

namespace felt {
namespace {

struct Found {
  double u = 0.0;
  double distance_squared = 0.0;
};

Found nearest_on(const Stroke& stroke, Point p) {
  Found best{0.0, distance_squared(stroke.position(0.0), p)};
  for (int i = 0; i < stroke.segment_count(); ++i) {
    const auto near = nearest_within(stroke.segment(i), p, best.distance_squared);
    if (near) best = {i + near->t, near->distance_squared};
  }
  return best;
}

/// Length from the start (or the end) over which two strokes are the same, in 64ths of the first.
double same_length_mm(const Stroke& a, const ArcMap& along_a, const Stroke& b,
                      const ArcMap& along_b, bool from_end) {
  constexpr int kSteps = 64;
  double same = 0.0;
  for (int k = 0; k <= kSteps; ++k) {
    const double s = along_a.length_mm() * k / kSteps;
    if (s > along_b.length_mm()) break;
    const double ua = along_a.u_at(from_end ? along_a.length_mm() - s : s);
    const double ub = along_b.u_at(from_end ? along_b.length_mm() - s : s);
    if (distance(a.position(ua), b.position(ub)) > kSharedPointMm) break;
    same = s;
  }
  return same;
}

}  // namespace

Point carried_along(const Stroke& before, const Stroke& after, double u) {
  const double n = before.segment_count();
  if (!before.closed() && u <= 0.0) return after.position(0.0);
  if (!before.closed() && u >= n) return after.position(after.segment_count());
  const Point p = before.position(u);
  if (nearest_on(after, p).distance_squared <= kSharedPointMm * kSharedPointMm) return p;
  const ArcMap old_arc(before, 1e-3), new_arc(after, 1e-3);
  const double first = same_length_mm(before, old_arc, after, new_arc, false);
  const double last = same_length_mm(before, old_arc, after, new_arc, true);
  const double changed = old_arc.length_mm() - first - last;
  const double now = new_arc.length_mm() - first - last;
  if (changed <= 0.0 || now <= 0.0) return p;
  const double share = std::clamp((old_arc.length_at(u) - first) / changed, 0.0, 1.0);
  return after.position(new_arc.u_at(first + share * now));
}

const std::vector<Junction>& ConnectedPull::junctions(const StrokeChange& change,
                                                      const Scene& scene) {
  const auto known = junctions_.find(change.id);
  if (known != junctions_.end()) return known->second;
  return junctions_
      .emplace(change.id, junctions_of(scene.document, scene.index, change.id, *change.before))
      .first->second;
}

StrokePtr ConnectedPull::pulled(StrokePtr stroke, double u, Point to) const {
  const Vec way = to - stroke->position(u);
  if (norm(way) < 1e-9) return stroke;
  auto result = BrushPull(stroke, u, brush_).at(way);
  return result ? std::make_shared<const Stroke>(*std::move(result)) : stroke;
}

/// Brings ends that lie on strokes of locked layers back to where they were.
void ConnectedPull::hold(StrokeChange& change, const Scene& scene) {
  const double n = change.before->segment_count();
  for (const Junction& j : junctions(change, scene)) {
    if (j.editable || change.before->closed() || (j.u > 0.0 && j.u < n)) continue;
    const double u = j.u <= 0.0 ? 0.0 : change.after->segment_count();
    change.after = pulled(change.after, u, change.before->position(j.u));
  }
}

void ConnectedPull::complete(Edit& edit, const Scene& scene) {
  std::set<StrokeId> known;
  for (const StrokeChange& c : edit.changes) known.insert(c.id);
  std::size_t begin = 0;
  for (int round = 0; round < kMaxRounds && begin < edit.changes.size(); ++round) {
    std::map<StrokeId, std::vector<Pull>> pulls;
    const std::size_t end = edit.changes.size();
    for (; begin < end; ++begin) {
      StrokeChange& change = edit.changes[begin];
      if (!change.before || !change.after || change.before == change.after) continue;
      hold(change, scene);
      for (const Junction& j : junctions(change, scene)) {
        if (!j.editable || known.contains(j.other)) continue;
        const Point to = carried_along(*change.before, *change.after, j.u);
        if (distance(to, change.before->position(j.u)) < 1e-9) continue;
        pulls[j.other].push_back({j.other_u, to});
      }
    }
    for (const auto& [id, places] : pulls) {
      if (known.size() > kMaxFollowers) return;
      known.insert(id);
      const StrokeReplacement& follower =
          followers_.try_emplace(id, scene.document, id).first->second;
      StrokePtr after = follower.before();
      const double n = after->segment_count();
      for (const Pull& pull : places) {
        const bool at_start = pull.u <= 0.0, at_end = pull.u >= n;
        const Point from = follower.before()->position(pull.u);
        const double u = after == follower.before() ? pull.u
                         : at_start                 ? 0.0
                         : at_end                   ? after->segment_count()
                                                    : nearest_on(*after, from).u;
        after = pulled(after, u, pull.to);
      }
      edit.changes.push_back(follower.with(std::move(after), edit.label).changes.front());
    }
  }
}

}  // namespace felt
