#include "felt/fill/fill_shape.h"

#include <algorithm>
#include <utility>

#include "felt/fill/curve_area.h"

namespace felt {
namespace {

/// Returns the number of cubics of a piece, as cubics_between() makes them.
std::size_t cubic_count(const FillPiece& piece) {
  if (!piece.stroke) return 1;
  constexpr double kSliver = 1e-12;
  const double low = std::max(std::min(piece.from, piece.to), 0.0);
  const double high = std::max(piece.from, piece.to);
  constexpr double kMaxSegments = 1e7;
  if (!(high < kMaxSegments)) return 0;
  std::size_t count = 0;
  for (auto start = static_cast<double>(static_cast<std::size_t>(low)); start < high;
       start += 1.0) {
    if (std::min(high - start, 1.0) - std::max(low - start, 0.0) > kSliver) ++count;
  }
  return std::max<std::size_t>(count, 1);
}

LoopStep step_of(const PlanarMap& map, std::size_t half_edge) {
  const MapEdge& edge = map.edges().edges[half_edge / 2];
  const auto& nodes = map.edges().nodes;
  LoopStep step{{edge.stroke, edge.from, edge.to}, nodes[edge.nodes[0]], nodes[edge.nodes[1]]};
  if (!edge.stroke) step.piece = {};
  if (half_edge % 2 != 0) {
    std::swap(step.piece.from, step.piece.to);
    std::swap(step.start, step.end);
  }
  return step;
}

bool continues(const LoopStep& a, const LoopStep& b) {
  return a.piece.stroke && a.piece.stroke == b.piece.stroke && a.piece.to == b.piece.from &&
         (a.piece.to > a.piece.from) == (b.piece.to > b.piece.from);
}

}  // namespace

std::vector<Cubic> cubics_of_step(const LoopStep& step, const LineMeetings& meetings) {
  std::vector<Cubic> cubics;
  if (const MeetingLine* line = meetings.find(step.piece.stroke)) {
    cubics = cubics_between(line->segments, step.piece.from, step.piece.to);
  }
  if (cubics.empty()) cubics.push_back(straight(step.start, step.end));
  cubics.front().p[0] = step.start;
  cubics.back().p[3] = step.end;
  return cubics;
}

FillLoop loop_of_steps(std::span<const LoopStep> steps, const LineMeetings& meetings) {
  FillLoop loop;
  loop.points.push_back(steps.front().start);
  for (const LoopStep& step : steps) {
    loop.pieces.push_back(step.piece);
    for (const Cubic& c : cubics_of_step(step, meetings)) {
      loop.points.insert(loop.points.end(), c.p.begin() + 1, c.p.end());
    }
  }
  loop.points.back() = loop.points.front();
  return loop;
}

FillLoop loop_of_map(const PlanarMap& map, const MapLoop& loop, const LineMeetings& meetings) {
  std::vector<LoopStep> steps;
  for (const std::size_t h : loop.half_edges) steps.push_back(step_of(map, h));
  std::size_t first = 0;  // starts where no piece runs through
  while (first + 1 < steps.size() &&
         continues(steps[(first + steps.size() - 1) % steps.size()], steps[first])) {
    ++first;
  }
  std::rotate(steps.begin(), steps.begin() + static_cast<std::ptrdiff_t>(first), steps.end());
  std::vector<LoopStep> merged;
  for (const LoopStep& step : steps) {
    if (merged.empty() || !continues(merged.back(), step)) {
      merged.push_back(step);
      continue;
    }
    merged.back().piece.to = step.piece.to;
    merged.back().end = step.end;
  }
  return loop_of_steps(merged, meetings);
}

std::vector<OldStep> old_steps(const FillLoop& loop) {
  std::vector<OldStep> steps;
  std::size_t first = 0;
  for (const FillPiece& piece : loop.pieces) {
    const std::size_t count = cubic_count(piece);
    if (count == 0 || first + 3 * count + 1 > loop.points.size()) return {};
    steps.push_back({piece, std::span(loop.points).subspan(first, 3 * count + 1)});
    first += 3 * count;
  }
  if (first + 1 != loop.points.size()) return {};
  return steps;
}

double area_of(const FillLoop& loop) noexcept {
  double area = 0.0;
  for (std::size_t i = 0; i + 3 < loop.points.size(); i += 3) {
    const auto& p = loop.points;
    area += area_under(Cubic{{p[i], p[i + 1], p[i + 2], p[i + 3]}}, p.front());
  }
  return area;
}

bool is_in_fill(const Fill& fill, Point p) noexcept {
  bool inside = false;
  for (const FillLoop& loop : fill.loops) inside ^= is_inside(loop.points, p);
  return inside;
}

}  // namespace felt
