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

std::vector<std::size_t> segments_in(const MeetingLine& line, const Rect& area) {
  std::vector<std::size_t> result;
  for (std::size_t i = 0; i < line.boxes.size(); ++i) {
    if (line.boxes[i].intersects(area)) result.push_back(i);
  }
  return result;
}

/// The intersection of cubics finds points up to kMeetMm apart, so boxes that nearly touch count.
Rect reach_of(const Rect& box) {
  return box.inflated(2.0 * kMeetMm + 1e-12 * (box.width() + box.height()));
}

void append(std::vector<Meeting>& meetings, const Crossings& found, std::size_t i, std::size_t j) {
  for (const Crossing& c : found) {
    meetings.push_back({static_cast<double>(i) + c.t1, static_cast<double>(j) + c.t2, c.point});
  }
}

std::vector<Meeting> meetings_of(const MeetingLine& a, const MeetingLine& b) {
  std::vector<Meeting> meetings;
  const Rect area = reach_of(b.box);
  if (!a.box.intersects(area)) return meetings;
  const auto of_b = segments_in(b, reach_of(a.box));
  for (const std::size_t i : segments_in(a, area)) {
    const Rect near = reach_of(a.boxes[i]);
    for (const std::size_t j : of_b) {
      if (b.boxes[j].intersects(near)) {
        append(meetings, intersections(a.segments[i], b.segments[j]), i, j);
      }
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

std::vector<Meeting> meetings_with_itself(const MeetingLine& a) {
  std::vector<Meeting> all, meetings;
  for (std::size_t i = 0; i < a.segments.size(); ++i) {
    if (const auto own = self_intersection(a.segments[i])) {
      const auto u = static_cast<double>(i);
      all.push_back({u + own->t1, u + own->t2, own->point});
    }
    const Rect near = reach_of(a.boxes[i]);
    for (std::size_t j = i + 1; j < a.segments.size(); ++j) {
      if (a.boxes[j].intersects(near)) {
        append(all, intersections(a.segments[i], a.segments[j]), i, j);
      }
    }
  }
  for (const Meeting& m : all) {
    if (!is_same_place(*a.stroke, m.u, m.v)) meetings.push_back(m);
  }
  return meetings;
}

}  // namespace

std::vector<Rect> LineMeetings::update(std::span<const FillLine> changes) {
  std::vector<Rect> areas;
  for (const FillLine& change : changes) {
    if (const MeetingLine* old = find(change.id)) {
      if (old->stroke == change.stroke) continue;
      areas.push_back(old->box.inflated(old->half_mm));
      remove(change.id);
    }
    if (!change.stroke) continue;
    add(change.id, change.stroke);
    const MeetingLine& now = lines_.at(change.id);
    areas.push_back(now.box.inflated(now.half_mm));
  }
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

void LineMeetings::remove(StrokeId id) {
  lines_.erase(id);
  for (auto line = lines_.begin(); line != lines_.end() && line->first < id; ++line) {
    line->second.meetings.erase(id);
  }
}

void LineMeetings::add(StrokeId id, const StrokePtr& stroke) {
  MeetingLine& line = lines_[id] = line_of(stroke);
  if (auto own = meetings_with_itself(line); !own.empty()) line.meetings[id] = std::move(own);
  for (auto& [other_id, other] : lines_) {
    if (other_id == id) continue;
    MeetingLine& low = other_id < id ? other : line;
    MeetingLine& high = other_id < id ? line : other;
    if (auto found = meetings_of(low, high); !found.empty()) {
      low.meetings[std::max(id, other_id)] = std::move(found);
    }
  }
}

}  // namespace felt
