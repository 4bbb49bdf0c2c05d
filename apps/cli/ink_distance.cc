#include "ink_distance.h"

#include <algorithm>
#include <cmath>

namespace felt::cli {
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

/// Calls `take` for places on a segment, at most kSpacingMm apart, its end left out.
template <class Take>
void for_each_place(const Cubic& segment, Take take) {
  const auto steps = static_cast<int>(std::clamp(control_length(segment) / kSpacingMm, 1.0, 1e5));
  for (int i = 0; i < steps; ++i) take(evaluate(segment, static_cast<double>(i) / steps));
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
    for_each_place(line.curve, [&](Point place) { add_place(curve, place); });
  }
  add_place(curve, meant.back());
  for (const BvhSegment& segment : curves) {
    for_each_place(segment.curve, [&](Point place) { add_place(path, place); });
  }
  add_place(path, curves.back().curve.p[3]);
}

void InkDistance::add_place(const SegmentBvh& tree, Point place) {
  const SegmentBvh::Hit hit = tree.nearest({.point = place});
  if (!hit) return;
  const double mm = std::sqrt(hit.nearest.distance_squared);
  places_.add(static_cast<std::int64_t>(std::min(mm * 1e6, 1e18)));
  sum_mm_ += mm;
  ++count_;
}

double InkDistance::mean_mm() const noexcept {
  return count_ > 0 ? sum_mm_ / static_cast<double>(count_) : 0.0;
}

}  // namespace felt::cli
