#include "felt/fill/fill_map.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <set>
#include <string>

#include "felt/fill/fill_shape.h"
#include "felt/geometry/nearest.h"

namespace felt {
namespace {

bool is_on_line(const LineMeetings& meetings, Point p) {
  for (const StrokeId id : meetings.lines_in(Rect{p.x, p.y, p.x, p.y}.inflated(kSnapMm))) {
    for (const Cubic& c : meetings.find(id)->segments) {
      if (nearest_within(c, p, kSnapMm * kSnapMm)) return true;
    }
  }
  return false;
}

std::string gap_text(const TipLink& gap) {
  char text[160];
  std::snprintf(text, sizeof text, ": it has a gap of %.2f mm at (%.2f, %.2f)", gap.length_mm,
                gap.from.point.x, gap.from.point.y);
  return text;
}

}  // namespace

void FillMap::update(std::span<const FillLine> changes) {
  const std::vector<Rect> areas = meetings_.update(changes);
  if (areas.empty()) return;
  for (auto& [gap, entry] : maps_) {
    entry.tips.forget(areas);
    entry.links.reset();
    entry.map.reset();
  }
}

const std::vector<TipLink>& FillMap::links(double max_gap_mm) {
  MapOfGap& entry = maps_.try_emplace(max_gap_mm, TipLinks(max_gap_mm)).first->second;
  if (!entry.links) entry.links = entry.tips.links(meetings_);
  return *entry.links;
}

const PlanarMap& FillMap::map(double max_gap_mm) {
  const std::vector<TipLink>& joined = links(max_gap_mm);
  MapOfGap& entry = maps_.at(max_gap_mm);
  if (!entry.map) entry.map = std::make_unique<PlanarMap>(divide_lines(meetings_, joined));
  return *entry.map;
}

FoundFill FillMap::fill_of(std::size_t loop, double max_gap_mm, Rgba color) {
  const PlanarMap& planar = map(max_gap_mm);
  FoundFill found;
  found.fill.color = color;
  found.fill.max_gap_mm = max_gap_mm;
  std::vector<std::size_t> loops = planar.holes_in(loop);
  loops.insert(loops.begin(), loop);
  std::set<std::size_t> links;
  for (const std::size_t i : loops) {
    found.fill.loops.push_back(loop_of_map(planar, planar.loops()[i], meetings_));
    for (const std::size_t h : planar.loops()[i].half_edges) {
      const MapEdge& edge = planar.edges().edges[h / 2];
      if (!edge.stroke && !planar.edges().links[edge.link].touch) links.insert(edge.link);
    }
  }
  for (const std::size_t link : links) found.bridges.push_back(planar.edges().links[link]);
  return found;
}

Result<FoundFill> FillMap::face_at(Point p, double max_gap_mm, Rgba color) {
  if (!is_in_range(p)) return fail(ErrorCode::kInvalidArgument, "the point is not on the page");
  if (!(max_gap_mm >= 0.0 && max_gap_mm <= kMaxCoordinateMm)) {
    return fail(ErrorCode::kInvalidArgument, "the size of gaps is not a length");
  }
  if (is_on_line(meetings_, p)) {
    return fail(ErrorCode::kInvalidArgument, "the point is on a line, not in an area");
  }
  const PlanarMap& planar = map(max_gap_mm);
  const auto loop = planar.loop_around(p);
  if (!loop) {
    const std::optional<TipLink> gap = find_gap(p, max_gap_mm);
    return fail(ErrorCode::kNotFound, "the area is open" + (gap ? gap_text(*gap) : ""));
  }
  FoundFill found = fill_of(*loop, max_gap_mm, color);
  std::size_t points = 0;
  for (const FillLoop& part : found.fill.loops) points += part.points.size();
  if (points > 3 * kMaxCubics) {
    return fail(ErrorCode::kLimitExceeded, "the boundary of the area has too many parts to fill");
  }
  if (!is_in_fill(found.fill, p)) {
    return fail(ErrorCode::kNotFound, "the area is too narrow to fill here");
  }
  return found;
}

std::optional<TipLink> FillMap::find_gap(Point p, double max_gap_mm) {
  // Looks with larger and larger bridges.
  for (double gap = 0.5; gap <= kMaxNamedGapMm; gap *= 2.0) {
    if (gap <= max_gap_mm) continue;
    const bool was_known = maps_.contains(gap);
    const auto loop = map(gap).loop_around(p);
    std::optional<TipLink> widest;
    if (loop) {
      for (const TipLink& bridge : fill_of(*loop, gap, {}).bridges) {
        if (!widest || bridge.length_mm > widest->length_mm) widest = bridge;
      }
    }
    if (!was_known) maps_.erase(gap);
    if (loop) return widest;
  }
  return std::nullopt;
}

}  // namespace felt
