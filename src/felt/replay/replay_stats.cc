#include "felt/replay/replay_stats.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "felt/io/ndjson/json_text.h"

namespace felt {
namespace {

constexpr double kSpacingMm = 0.1;

SegmentBvh tree_of(const std::vector<BvhSegment>& segments) {
  SegmentBvh tree;
  tree.build(segments);
  return tree;
}

std::vector<BvhSegment> lines_of(std::span<const Point> path) {
  std::vector<BvhSegment> lines;
  for (std::size_t i = 1; i < path.size(); ++i)
    lines.push_back({straight(path[i - 1], path[i]), {}});
  if (path.size() == 1) lines.push_back({straight(path[0], path[0]), {}});
  return lines;
}

/// Calls `use` for points on a segment, at most kSpacingMm apart. The end of the segment is left
/// out.
template <class Use>
void for_each_point(const Cubic& segment, Use use) {
  const auto steps = static_cast<int>(std::clamp(control_length(segment) / kSpacingMm, 1.0, 1e5));
  for (int i = 0; i < steps; ++i) use(evaluate(segment, static_cast<double>(i) / steps));
}

}  // namespace

void InkDistance::add(std::span<const Point> meant, std::span<const Stroke> ink) {
  if (meant.empty() || ink.empty()) return;
  const std::vector<BvhSegment> lines = lines_of(meant);
  const SegmentBvh path = tree_of(lines);
  std::vector<BvhSegment> curves;
  for (const Stroke& stroke : ink) {
    for (int i = 0; i < stroke.segment_count(); ++i) curves.push_back({stroke.segment(i), {}});
  }
  const SegmentBvh curve = tree_of(curves);
  for (const BvhSegment& line : lines) {
    for_each_point(line.curve, [&](Point point) { add_point(curve, point); });
  }
  add_point(curve, meant.back());
  for (const BvhSegment& segment : curves) {
    for_each_point(segment.curve, [&](Point point) { add_point(path, point); });
  }
  add_point(path, curves.back().curve.p[3]);
}

void InkDistance::add_point(const SegmentBvh& tree, Point point) {
  const SegmentBvh::Hit hit = tree.nearest({.point = point});
  if (!hit) return;
  const double mm = std::sqrt(hit.nearest.distance_squared);
  points_nm_.add(static_cast<std::int64_t>(std::min(mm * 1e6, 1e18)));
  sum_mm_ += mm;
  ++count_;
}

double InkDistance::mean_mm() const noexcept {
  return count_ > 0 ? sum_mm_ / static_cast<double>(count_) : 0.0;
}

std::string stats_json(const ReplayStats& stats) {
  const auto count = [](std::int64_t n) { return std::to_string(n); };
  JsonObject object;
  object.add_raw("ticks", count(stats.ticks));
  object.add_number("simulated_s", stats.simulated_s);
  object.add_number("wall_s", stats.wall_s);
  object.add_number("times_real_time", stats.times_real_time());
  object.add_raw("touches", count(stats.touches));
  object.add_raw("strokes_meant", count(stats.strokes_meant));
  object.add_raw("strokes", count(stats.strokes));
  object.add_raw("strokes_changed", count(stats.strokes_changed));
  object.add_raw("segments", count(stats.segments));
  object.add_raw("edits", count(stats.edits));
  object.add_raw("soft_faults", count(stats.soft_faults));
  object.add_raw("hard_faults", count(stats.hard_faults));
  object.add_number("max_asked_n", stats.max_asked_n);
  object.add_number("max_force_n", stats.max_sent_n);
  object.add_number("mean_contact_force_n", stats.mean_sent_n());
  if (stats.cues) object.add_raw("cues", count(*stats.cues));
  if (stats.distance.count() == 0) {
    object.add_raw("intended_to_ink_mm", "null");
  } else {
    JsonObject distance;
    distance.add_number("mean", stats.distance.mean_mm());
    distance.add_number("p95", stats.distance.p95_mm());
    distance.add_number("max", stats.distance.max_mm());
    object.add_raw("intended_to_ink_mm", distance.text());
  }
  return object.text() + "\n";
}

}  // namespace felt
