#include "felt/tools/pull/nib_lines.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "felt/tools/junctions.h"
#include "felt/tools/pull/nearest_u.h"

namespace felt {
namespace {

/// Points nearer to each other than this are joined.
constexpr double kJoinedMm = 1e-9;
/// Largest gap that the refit may leave. It is far below kSharedPointMm, so that the strokes stay
/// connected through many gestures.
constexpr double kCommittedGapMm = 1e-6;
/// Added to the radius by each round of a stroke after the first kExactVisits, mm.
constexpr double kRoundRoomMm = 2e-4;
/// Largest movement of a shared point in one pull, in radii. A step of the nib is half a radius.
constexpr double kMaxPullRadii = 4.0;

}  // namespace

bool NibLines::move(Point from, Point to, Vec came_from, const Scene& scene) {
  const double wanted = std::ceil(distance(from, to) / (0.5 * radius_mm_));
  const int steps = static_cast<int>(std::clamp(wanted, 1.0, 1.0 * NibPush::kMaxSteps));
  // A motion through which the nib cannot go in steps of half a radius has kMaxSteps steps in all.
  const bool is_leap = !(wanted <= 1.0 * NibPush::kMaxSteps * NibPush::kMaxSteps);
  const int parts = is_leap ? 1 : NibPush::kMaxSteps;
  meet(scene, from, to);
  bool moved = false;
  for (int k = 1; k <= steps; ++k) {
    const Point a = lerp(from, to, (k - 1.0) / steps);
    const Point b = k == steps ? to : lerp(from, to, static_cast<double>(k) / steps);
    for (auto& [id, line] : lines_) {
      line.visits = 0;
      if (!line.has_links) find_links(id, line, scene);
      note_touch(line, a, b);
      if (!is_held_under(line, b) && line.push.step(a, b, came_from, parts)) queue(id, line);
    }
    moved = moved || !queue_.empty();
    if (weld(b, came_from, &scene)) continue;
    // The ink cannot be joined under this nib, so the nib moves over it. Free lines are pushed.
    for (auto& [id, line] : lines_) {
      line.push.undo();
      if (line.links.empty()) moved = line.push.step(from, to, came_from) || moved;
    }
    break;
  }
  for (auto& [id, line] : lines_) line.push.settle();
  return moved;
}

NibLines::Line& NibLines::add(StrokeReplacement place, StrokePtr ink) {
  const StrokeId id = place.id();
  return lines_.try_emplace(id, std::move(place), std::move(ink), radius_mm_).first->second;
}

/// Adds the strokes that the nib meets for the first time.
void NibLines::meet(const Scene& scene, Point from, Point to) {
  Rect path;
  path.extend(from);
  path.extend(to);
  scene.index.for_each_segment_in(path.inflated(radius_mm_), [&](StrokeId id, int segment) {
    if (lines_.contains(id)) return;
    const StrokePtr stroke = scene.document.find(id);
    if (!nib_meets(stroke->segment(segment), from, to, radius_mm_)) return;
    add(StrokeReplacement(scene.document, id), stroke).touched = true;
  });
}

/// Notes the first touch of a stroke that has followed others so far. Its force begins at zero.
void NibLines::note_touch(Line& line, Point from, Point to) const {
  if (line.touched) return;
  for (const Point p : {from, to}) {
    const auto under = line.push.under(p, radius_mm_);
    if (!under) continue;
    line.touched = true;
    line.carried_mm = under->displacement_mm;
    return;
  }
}

/// Returns true if a nib at p covers a point at which the stroke is held. The nib cannot push the
/// stroke out from under it.
bool NibLines::is_held_under(const Line& line, Point p) const {
  return std::any_of(line.links.begin(), line.links.end(), [&](const Line::Link& link) {
    return link.held && distance(link.start, p) < radius_mm_;
  });
}

double NibLines::gap_mm() const {
  double largest = 0.0;
  for (const auto& [id, line] : lines_) {
    for (const Line::Link& link : line.links) {
      const Point here = line.push.position(link.u);
      const auto other = lines_.find(link.other);
      if (!link.held && other == lines_.end()) continue;
      const Point there =
          link.held ? link.start : other->second.push.position(link.other_u) - link.offset;
      largest = std::max(largest, distance(here, there));
    }
  }
  return largest;
}

void NibLines::queue(StrokeId id, Line& line) {
  if (line.waits || line.visits >= kMaxVisits) return;
  line.waits = true;
  queue_.push_back(id);
}

NibLines::Line* NibLines::follower(StrokeId id, const Scene* scene) {
  const auto known = lines_.find(id);
  if (known != lines_.end()) return &known->second;
  if (!scene || followers_ >= kMaxFollowers) return nullptr;
  ++followers_;
  return &add(StrokeReplacement(scene->document, id), scene->document.find(id));
}

void NibLines::find_links(StrokeId id, Line& line, const Scene& scene) const {
  line.has_links = true;
  const Stroke& stroke = *line.replacement.before();
  for (const Junction& j : junctions_of(scene.document, scene.index, id, stroke)) {
    const Point here = stroke.position(j.u);
    const Point there = scene.document.find(j.other)->position(j.other_u);
    Line::Link link{j.u, j.other, j.other_u, here, there - here, !j.editable};
    // An end near a joint or a seam lies on two segments. The nearer place counts.
    const auto known = std::find_if(line.links.begin(), line.links.end(), [&](const auto& k) {
      return k.other == j.other && distance(k.start, here) <= 2.0 * kSharedPointMm &&
             distance(k.start + k.offset, there) <= 2.0 * kSharedPointMm;
    });
    if (known == line.links.end()) {
      line.links.push_back(link);
    } else if (norm(link.offset) < norm(known->offset)) {
      *known = link;
    }
  }
  for (const Line::Link& link : line.links) line.pins.push_back(link.u);
  std::sort(line.pins.begin(), line.pins.end());
}

/// Returns false if the strokes move farther and farther instead of coming together.
bool NibLines::weld(Point p, Vec came_from, const Scene* scene) {
  bool good = true;
  for (std::size_t k = 0; good && k < queue_.size(); ++k) {
    const StrokeId id = queue_[k];
    Line& line = lines_.at(id);
    line.waits = false;
    ++line.visits;
    if (scene && !line.has_links) find_links(id, line, *scene);
    good = visit(line, p, came_from, scene);
  }
  for (const StrokeId id : queue_) lines_.at(id).waits = false;
  queue_.clear();
  for (auto& [id, line] : lines_) {
    const bool is_late = good && line.visits >= kMaxVisits && !is_held_under(line, p);
    if (is_late) line.push.clear(p, came_from, 0.0);
  }
  return good;
}

/// Pushes a stroke out from under the nib, holds its ends on locked strokes and pulls the strokes
/// that share a point with it. Returns false if a point would have to move much farther than the
/// nib.
bool NibLines::visit(Line& line, Point p, Vec came_from, const Scene* scene) {
  const double room = kRoundRoomMm * std::max(0, line.visits - kExactVisits);
  if (!is_held_under(line, p)) line.push.clear(p, came_from, room);
  for (const Line::Link& link : line.links) {
    if (link.held) pull(line, link.u, link.start);
  }
  for (const Line::Link& link : line.links) {
    if (link.held) continue;
    const Point here = line.push.position(link.u);
    if (distance(here, link.start) < kJoinedMm && !lines_.contains(link.other)) continue;
    Line* other = follower(link.other, scene);
    if (!other) continue;
    const Point target = here + link.offset;
    if (!(distance(other->push.position(link.other_u), target) < kMaxPullRadii * radius_mm_)) {
      return false;
    }
    if (pull(*other, link.other_u, target)) queue(link.other, *other);
  }
  return true;
}

/// Moves a shared point of a stroke. Returns true if the ink moved.
bool NibLines::pull(Line& line, double u, Point target) {
  constexpr double kSameU = 1e-6;
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  if (distance(line.push.position(u), target) <= kJoinedMm) return false;
  std::pair<double, double> pins{kNone, kNone};
  const auto after = std::upper_bound(line.pins.begin(), line.pins.end(), u + kSameU);
  const auto before = std::lower_bound(line.pins.begin(), line.pins.end(), u - kSameU);
  if (after != line.pins.end()) pins.second = *after;
  if (before != line.pins.begin()) pins.first = *(before - 1);
  if (line.replacement.before()->closed() && !line.pins.empty()) {
    if (std::isnan(pins.second) && line.pins.front() < u - kSameU) pins.second = line.pins.front();
    if (std::isnan(pins.first) && line.pins.back() > u + kSameU) pins.first = line.pins.back();
  }
  return line.push.pull(u, target, pins) || line.push.pull(u, target, {kNone, kNone});
}

double NibLines::largest_gap_mm(const std::vector<StrokeId>& ids) const {
  double largest = 0.0;
  for (const StrokeId id : ids) {
    const Line& line = lines_.at(id);
    for (const Line::Link& link : line.links) {
      const auto other = lines_.find(link.other);
      if (link.held || other == lines_.end()) continue;
      const Point here = line.push.position(link.u) + link.offset;
      largest = std::max(largest, distance(here, other->second.push.position(link.other_u)));
    }
  }
  return largest;
}

/// Copies the shared points of a line of `from` to the same line after the refit, which has other
/// parameters. Points that have not moved stay.
void NibLines::copy_links(const Line& line, Line& to, const NibLines& from) const {
  const auto refitted_u = [](const Line& a, const Line& b, double u) {
    const Stroke &before = *a.replacement.before(), &after = *b.push.stroke();
    if (!before.closed() && u <= 0.0) return 0.0;
    if (!before.closed() && u >= before.segment_count()) return 1.0 * after.segment_count();
    return nearest_u(after, a.push.position(u));
  };
  for (Line::Link link : line.links) {
    const auto other = lines_.find(link.other);
    const bool stays = distance(line.push.position(link.u), link.start) < kJoinedMm;
    if (other == lines_.end() && !link.held && !stays) continue;
    if (other == lines_.end()) {
      link.held = true;
    } else {
      link.other_u = refitted_u(from.lines_.at(link.other), other->second, link.other_u);
    }
    link.u = refitted_u(line, to, link.u);
    to.pins.push_back(link.u);
    to.links.push_back(link);
  }
  std::sort(to.pins.begin(), to.pins.end());
}

/// Returns the ids of the strokes that have moved, in groups of strokes that share points.
std::vector<std::vector<StrokeId>> NibLines::moved_groups() const {
  std::map<StrokeId, StrokeId> parents;  // a forest: each tree is a group
  const auto root = [&](StrokeId id) {
    while (parents.at(id) != id) id = parents.at(id);
    return id;
  };
  for (const auto& [id, line] : lines_) {
    if (line.push.stroke() != line.replacement.before()) parents.emplace(id, id);
  }
  for (const auto& [id, self] : parents) {
    for (const Line::Link& link : lines_.at(id).links) {
      if (parents.contains(link.other)) parents[root(id)] = root(link.other);
    }
  }
  std::map<StrokeId, std::vector<StrokeId>> groups;
  for (const auto& [id, parent] : parents) groups[root(id)].push_back(id);
  std::vector<std::vector<StrokeId>> result;
  for (auto& [id, ids] : groups) result.push_back(std::move(ids));
  return result;
}

std::vector<std::pair<StrokeId, StrokePtr>> NibLines::finished(Point pen) const {
  std::vector<std::pair<StrokeId, StrokePtr>> all;
  for (const std::vector<StrokeId>& ids : moved_groups()) {
    for (auto& [id, stroke] : finished_group(ids, pen)) all.emplace_back(id, std::move(stroke));
  }
  std::sort(all.begin(), all.end(),
            [](const auto& one, const auto& two) { return one.first < two.first; });
  return all;
}

/// Refits the strokes of a group, or returns them as they are if one of them cannot be refitted or
/// would leave its place.
std::vector<std::pair<StrokeId, StrokePtr>> NibLines::finished_group(
    const std::vector<StrokeId>& ids, Point pen) const {
  std::vector<std::pair<StrokeId, StrokePtr>> raw, done;
  for (const StrokeId id : ids) raw.emplace_back(id, lines_.at(id).push.stroke());
  NibLines fine(radius_mm_);
  for (const StrokeId id : ids) {
    const Line& line = lines_.at(id);
    Result<Stroke> refitted = line.push.finished(pen);
    if (!refitted) return raw;
    fine.add(line.replacement, std::make_shared<const Stroke>(*std::move(refitted)));
  }
  for (auto& [id, next] : fine.lines_) {
    fine.copy_links(lines_.at(id), next, *this);
    fine.queue(id, next);
  }
  if (!fine.weld(pen, {}, nullptr)) return raw;
  for (auto& [id, next] : fine.lines_) next.push.settle();
  if (fine.largest_gap_mm(ids) > std::max(kCommittedGapMm, largest_gap_mm(ids))) return raw;
  for (const auto& [id, next] : fine.lines_) {
    const double within = radius_mm_ - kCommittedGapMm;
    if (next.push.under(pen, within) && !lines_.at(id).push.under(pen, within)) return raw;
    done.emplace_back(id, next.push.stroke());
  }
  return done;
}

}  // namespace felt
