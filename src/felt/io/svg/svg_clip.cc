#include "felt/io/svg/svg_clip.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

#include "felt/geometry/cubic.h"
#include "felt/geometry/roots.h"

namespace felt {
namespace {

/// A part of a curve on one side of an edge.
struct ClipPart {
  Cubic curve;
  bool is_inside = false;
};

/// Appends the parts of a curve on both sides of an edge.
void split_at(const Cubic& c, const SvgHalfPlane& edge, std::vector<ClipPart>& out) {
  std::array<double, 4> d{};
  for (std::size_t i = 0; i < 4; ++i) d[i] = edge.outside_mm(c.p[i]);
  const auto is_in = [](double value) { return value <= 0.0; };
  if (std::all_of(d.begin(), d.end(), is_in)) return out.push_back({c, true});
  if (std::none_of(d.begin(), d.end(), is_in)) return out.push_back({c, false});
  double from = 0.0;
  const auto add = [&](double to) {
    if (!(to > from)) return;
    const Cubic part = sub_segment(c, from, to);
    out.push_back({part, edge.outside_mm(evaluate(part, 0.5)) <= 0.0});
    from = to;
  };
  for (const double t : cubic_roots(d[0], 3.0 * (d[1] - d[0]), 3.0 * (d[2] - 2.0 * d[1] + d[0]),
                                    d[3] - 3.0 * d[2] + 3.0 * d[1] - d[0])) {
    add(t);
  }
  add(1.0);
}

std::vector<ClipPart> parts_of(const std::vector<Point>& points, const SvgHalfPlane& edge) {
  std::vector<ClipPart> parts;
  for (std::size_t i = 0; i + 3 < points.size(); i += 3) {
    split_at({{points[i], points[i + 1], points[i + 2], points[i + 3]}}, edge, parts);
  }
  return parts;
}

/// Appends a curve, after a straight line to its beginning if there is a gap.
void append_curve(std::vector<Point>& points, const Cubic& c) {
  const auto add = [&](const Cubic& part) {
    points.insert(points.end(), part.p.begin() + 1, part.p.end());
  };
  if (points.empty()) points.push_back(c.p[0]);
  if (points.back() != c.p[0]) add(straight(points.back(), c.p[0]));
  add(c);
}

/// Cuts a closed loop at one edge (Sutherland and Hodgman, doi:10.1145/360767.360802). Parts of the
/// loop along the edge cover no area.
std::vector<Point> cut_loop(const std::vector<Point>& loop, const SvgHalfPlane& edge) {
  std::vector<Point> kept;
  for (const ClipPart& part : parts_of(loop, edge)) {
    if (part.is_inside) append_curve(kept, part.curve);
  }
  if (!kept.empty() && kept.front() != kept.back()) {
    const Point begin = kept.front();
    append_curve(kept, straight(kept.back(), begin));
  }
  return kept;
}

/// Appends the parts of an open or closed line on the inner side of an edge.
void cut_line(const SvgContour& line, const SvgHalfPlane& edge, std::vector<SvgContour>& out) {
  const std::vector<ClipPart> parts = parts_of(line.points, edge);
  const auto is_inside = [](const ClipPart& part) { return part.is_inside; };
  if (std::all_of(parts.begin(), parts.end(), is_inside)) return out.push_back(line);
  const std::size_t first = out.size();
  bool is_open = false;
  for (const ClipPart& part : parts) {
    if (part.is_inside && !is_open) out.push_back({});
    is_open = part.is_inside;
    if (is_open) append_curve(out.back().points, part.curve);
  }
  // The begin of a closed line is in the middle of a part.
  if (!line.closed || out.size() < first + 2 || !is_open || !parts.front().is_inside) return;
  std::vector<Point>& begin = out[first].points;
  std::vector<Point>& end = out.back().points;
  end.insert(end.end(), begin.begin() + 1, begin.end());
  begin = std::move(end);
  out.pop_back();
}

}  // namespace

void clip_fill(Fill& fill, const SvgFrame& frame) {
  std::vector<FillLoop> kept;
  for (FillLoop& loop : fill.loops) {
    std::vector<Point> points = loop.points;
    for (const SvgHalfPlane& edge : frame.planes()) points = cut_loop(points, edge);
    if (points.empty()) continue;
    if (points != loop.points) loop = {std::move(points), {}};
    kept.push_back(std::move(loop));
  }
  fill.loops = std::move(kept);
}

std::vector<SvgContour> clip_line(const SvgContour& contour, const SvgFrame& frame) {
  std::vector<SvgContour> lines{contour};
  for (const SvgHalfPlane& edge : frame.planes()) {
    std::vector<SvgContour> kept;
    for (const SvgContour& line : lines) cut_line(line, edge, kept);
    lines = std::move(kept);
  }
  return lines;
}

}  // namespace felt
