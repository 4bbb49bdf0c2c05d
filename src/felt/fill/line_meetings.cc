#include "felt/fill/line_meetings.h"

#include <algorithm>
#include <utility>

#include "felt/geometry/cubic.h"
#include "felt/geometry/intersect.h"

namespace felt {
namespace {

MeetingLine line_of(const StrokePtr& stroke) {
  MeetingLine line;
  line.stroke = stroke;
  for (int i = 0; i < stroke->segment_count(); ++i) {
    line.segments.push_back(stroke->segment(i));
    line.boxes.push_back(bounds(line.segments.back()));
    line.box.extend(line.boxes.back());
  }
  for (const WidthKnot& knot : stroke->widths()) {
    line.half_mm = std::max(line.half_mm, 0.5 * knot.width_mm);
  }
  return line;
}

/// The intersection of cubics finds points up to kMeetMm apart, so boxes that nearly touch count.
double reach_mm(double width_and_height_mm) {
  return 2.0 * kMeetMm + 1e-12 * width_and_height_mm;
}

Rect reach_of(const Rect& box) {
  return box.inflated(reach_mm(box.width() + box.height()));
}

/// A segment of one stroke and a segment of another, or of the same stroke.
using SegmentPair = std::pair<std::size_t, std::size_t>;

void append(std::vector<Meeting>& meetings, const Crossings& found, std::size_t i, std::size_t j) {
  for (const Crossing& c : found) {
    meetings.push_back({static_cast<double>(i) + c.t1, static_cast<double>(j) + c.t2, c.point});
  }
}

std::vector<Meeting> meetings_of(const MeetingLine& a, const MeetingLine& b,
                                 std::span<const SegmentPair> pairs) {
  std::vector<Meeting> meetings;
  for (const auto& [i, j] : pairs) {
    if (b.boxes[j].intersects(reach_of(a.boxes[i]))) {
      append(meetings, intersections(a.segments[i], b.segments[j]), i, j);
    }
  }
  return meetings;
}

/// Returns true if the two parameters are the same point of the stroke: a joint, or its seam.
bool is_same_place(const Stroke& stroke, double u, double v) {
  constexpr double kSame = 1e-7;
  const double n = stroke.segment_count();
  return v - u <= kSame || (stroke.closed() && u + n - v <= kSame);
}

std::vector<Meeting> meetings_with_itself(const MeetingLine& a,
                                          std::span<const SegmentPair> pairs) {
  std::vector<Meeting> meetings = meetings_of(a, a, pairs);
  for (std::size_t i = 0; i < a.segments.size(); ++i) {
    if (const auto own = self_intersection(a.segments[i])) {
      const auto u = static_cast<double>(i);
      meetings.push_back({u + own->t1, u + own->t2, own->point});
    }
  }
  std::erase_if(meetings, [&](const Meeting& m) { return is_same_place(*a.stroke, m.u, m.v); });
  return meetings;
}

}  // namespace

std::vector<Rect> LineMeetings::update(std::span<const FillLine> changes) {
  std::vector<Rect> areas;
  std::vector<SegmentForest::Change> moved;
  std::vector<StrokeId> changed;
  for (const FillLine& change : changes) {
    const MeetingLine* old = find(change.id);
    if (old ? old->stroke == change.stroke : !change.stroke) continue;
    moved.push_back({change.id, change.stroke});
    if (old) {
      areas.push_back(old->box.inflated(old->half_mm));
      remove(change.id);
    }
    if (!change.stroke) continue;
    const MeetingLine& now = lines_[change.id] = line_of(change.stroke);
    areas.push_back(now.box.inflated(now.half_mm));
    changed.push_back(change.id);
    widest_half_mm_ = std::max(widest_half_mm_, now.half_mm);
    for (const Rect& box : now.boxes) {
      largest_mm_ = std::max(largest_mm_, box.width() + box.height());
    }
  }
  segments_.update(moved);
  std::sort(changed.begin(), changed.end());
  for (const StrokeId id : changed) meet(id, changed);
  return areas;
}

const MeetingLine* LineMeetings::find(StrokeId id) const {
  const auto found = lines_.find(id);
  return found == lines_.end() ? nullptr : &found->second;
}

std::vector<Meeting> LineMeetings::between(StrokeId first, StrokeId second) const {
  const MeetingLine* line = find(std::min(first, second));
  if (!line) return {};
  const auto found = line->meetings.find(std::max(first, second));
  if (found == line->meetings.end()) return {};
  std::vector<Meeting> result = found->second;
  if (second < first) {
    for (Meeting& m : result) std::swap(m.u, m.v);
  }
  return result;
}

std::vector<StrokeId> LineMeetings::lines_in(const Rect& area) const {
  std::vector<StrokeId> ids;
  segments_.for_each_in(area, [&](StrokeId id, int) { ids.push_back(id); });
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  return ids;
}

void LineMeetings::remove(StrokeId id) {
  const auto line = lines_.find(id);
  for (const StrokeId lower : line->second.lower) lines_.at(lower).meetings.erase(id);
  for (const auto& [higher, meetings] : line->second.meetings) {
    if (higher != id) std::erase(lines_.at(higher).lower, id);
  }
  lines_.erase(line);
}

/// Finds the meetings of a stroke with itself and with all strokes except lower ones of `changed`,
/// which have found theirs with this stroke already.
void LineMeetings::meet(StrokeId id, std::span<const StrokeId> changed) {
  MeetingLine& line = lines_.at(id);
  std::map<StrokeId, std::vector<SegmentPair>> near{{id, {}}};  // the one of the lower id first
  for (std::size_t i = 0; i < line.segments.size(); ++i) {
    segments_.for_each_in(
        line.boxes[i].inflated(reach_mm(largest_mm_)), [&](StrokeId other, int segment) {
          const auto j = static_cast<std::size_t>(segment);
          if (other == id && j <= i) return;
          if (other < id && std::binary_search(changed.begin(), changed.end(), other)) return;
          near[other].push_back(other < id ? SegmentPair(j, i) : SegmentPair(i, j));
        });
  }
  for (auto& [other, pairs] : near) {
    std::sort(pairs.begin(), pairs.end());
    if (other == id) {
      if (auto own = meetings_with_itself(line, pairs); !own.empty()) {
        line.meetings[id] = std::move(own);
      }
      continue;
    }
    const auto [low, high] = std::minmax(id, other);
    auto found = meetings_of(lines_.at(low), lines_.at(high), pairs);
    if (found.empty()) continue;
    lines_.at(low).meetings[high] = std::move(found);
    lines_.at(high).lower.push_back(low);
  }
}

}  // namespace felt
