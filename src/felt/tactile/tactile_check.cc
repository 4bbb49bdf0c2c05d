#include "felt/tactile/tactile_check.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "felt/tactile/inner_circle.h"
#include "felt/tactile/line_gaps.h"
#include "felt/tactile/seen_ink.h"
#include "felt/tactile/touch_lines.h"

namespace felt {
namespace {

constexpr double kToleranceMm = 0.05;

/// A shape whose lines are shorter than this, in widths of its lines, is a dot.
constexpr double kDotWidths = 1.0;

/// The shortest line that cannot be a dot: files write dots as lines of almost no length.
constexpr double kSmallDotMm = 0.1;

/// Files round widths.
constexpr double kWidthToleranceMm = 0.01;

Point middle_of(const Rect& box) noexcept {
  return {0.5 * (box.x0 + box.x1), 0.5 * (box.y0 + box.y1)};
}

/// The strokes and fills of a document that are seen on the paper.
struct VisibleParts {
  std::vector<std::pair<StrokeId, StrokePtr>> strokes;
  std::vector<FillPtr> fills;
};

VisibleParts visible_parts(const Document& document, Rgba paper) {
  VisibleParts parts;
  for (const Layer& layer : document.layers()) {
    if (!layer.visible) continue;
    const double opacity = layer_opacity(layer);
    for (const StrokeId id : layer.strokes) {
      StrokePtr stroke = document.find(id);
      if (is_seen(stroke->color(), opacity, paper)) {
        parts.strokes.emplace_back(id, std::move(stroke));
      }
    }
    for (const FillId id : layer.fills) {
      FillPtr fill = document.find_fill(id);
      if (is_seen(fill->color, opacity, paper)) parts.fills.push_back(std::move(fill));
    }
  }
  return parts;
}

Result<TouchLines> touch_lines_of(const VisibleParts& parts) {
  TouchLines lines;
  double legs_mm = 0.0;
  for (const auto& [id, stroke] : parts.strokes) {
    for (int i = 0; i < stroke->segment_count(); ++i) {
      const Cubic c = stroke->segment(i);
      legs_mm += distance(c.p[0], c.p[1]) + distance(c.p[1], c.p[2]) + distance(c.p[2], c.p[3]);
    }
    if (!(legs_mm <= kMaxTactileMm)) {
      return fail(ErrorCode::kUnsupported,
                  "the lines are longer than 100 m: too much for a raised drawing");
    }
    lines.add(id, *stroke);
  }
  return lines;
}

Rect bounds_of(const TouchLines& lines, const std::vector<std::uint32_t>& shape) {
  Rect box;
  for (const std::uint32_t i : shape) box.extend(lines.lines[i].bounds);
  return box;
}

bool is_dot(const TouchLines& lines, const std::vector<std::uint32_t>& shape) {
  return std::all_of(shape.begin(), shape.end(), [&](std::uint32_t i) {
    const TouchLine& line = lines.lines[i];
    return line.length_mm <= kDotWidths * line.mean_width_mm;
  });
}

/// Adds a fault for each side between two corners of a closed line. Corners within one width of the
/// line are one corner: files imitate pointed corners by short pieces.
void add_short_sides(const TouchLine& line, std::span<const TouchPoint> points,
                     const Stroke& stroke, std::vector<TactileFault>& faults) {
  if (!stroke.closed()) return;
  std::vector<Point> corners;
  for (int i = 0; i < stroke.segment_count(); ++i) {
    if (stroke.joint(i) == JointKind::kCorner) corners.push_back(stroke.segment(i).p[0]);
  }
  if (corners.size() < 2) return;
  std::vector<const TouchPoint*> at;  // the points of the corners
  for (const TouchPoint& p : points) {
    if (at.size() < corners.size() && p.at == corners[at.size()]) at.push_back(&p);
  }
  for (std::size_t i = 0; i < at.size(); ++i) {
    const bool is_last = i + 1 == at.size();
    const TouchPoint &from = *at[i], &to = *at[is_last ? 0 : i + 1];
    const double side = (is_last ? line.length_mm : 0.0) + to.along_mm - from.along_mm;
    if (side > line.mean_width_mm && side < TactileLimits::kShapeMm) {
      faults.push_back({TactileRule::kShortSide,
                        lerp(from.at, to.at, 0.5),
                        side,
                        TactileLimits::kShapeMm,
                        0.0,
                        line.stroke,
                        {}});
    }
  }
}

void add_shape_faults(const VisibleParts& parts, const TouchLines& lines,
                      std::vector<TactileFault>& faults) {
  std::vector<TactileFault> sides;
  for (const std::vector<std::uint32_t>& shape : shapes_of(lines)) {
    const Rect box = bounds_of(lines, shape);
    const double size = std::max(box.width(), box.height());
    if (size < TactileLimits::kShapeMm) {
      if (is_dot(lines, shape)) continue;
      faults.push_back({TactileRule::kSmallShape,
                        middle_of(box),
                        size,
                        TactileLimits::kShapeMm,
                        0.0,
                        lines.lines[shape.front()].stroke,
                        {}});
      continue;
    }
    for (const std::uint32_t i : shape) {
      add_short_sides(lines.lines[i], lines.points_of(lines.lines[i]), *parts.strokes[i].second,
                      sides);
    }
  }
  faults.insert(faults.end(), sides.begin(), sides.end());
}

void add_area_faults(const VisibleParts& parts, std::vector<TactileFault>& faults) {
  Outline polygons;
  for (const FillPtr& fill : parts.fills) {
    flatten_fill(*fill, kToleranceMm, polygons);
    const InnerCircle inner = largest_inner_circle(polygons, kToleranceMm);
    if (inner.diameter_mm < TactileLimits::kAreaMm - kToleranceMm) {
      faults.push_back({TactileRule::kNarrowArea,
                        inner.center,
                        inner.diameter_mm,
                        TactileLimits::kAreaMm,
                        0.0,
                        {},
                        {}});
    }
  }
}

/// Returns the number of styles if widths that differ by less than kStyleMm are one style.
std::size_t count_styles(const TouchLines& lines) {
  std::vector<double> widths;
  for (const TouchLine& line : lines.lines) widths.push_back(line.mean_width_mm);
  std::sort(widths.begin(), widths.end());
  std::size_t styles = 0;
  for (std::size_t i = 0, first = 0; i < widths.size(); ++i) {
    if (i > 0 && widths[i] - widths[first] < TactileLimits::kStyleMm) continue;
    first = i;
    ++styles;
  }
  return styles;
}

std::size_t count_colors(const VisibleParts& parts) {
  std::vector<Rgba> colors;
  for (const FillPtr& fill : parts.fills) {
    if (std::find(colors.begin(), colors.end(), fill->color) == colors.end()) {
      colors.push_back(fill->color);
    }
  }
  return colors.size();
}

void add_whole_faults(const VisibleParts& parts, const TouchLines& lines,
                      std::vector<TactileFault>& faults) {
  Rect box;
  for (const TouchLine& line : lines.lines) box.extend(line.bounds);
  for (const FillPtr& fill : parts.fills) box.extend(fill_bounds(*fill));
  const auto add = [&](TactileRule rule, double measured, double limit) {
    if (measured > limit) faults.push_back({rule, middle_of(box), measured, limit, 0.0, {}, {}});
  };
  add(TactileRule::kLineStyles, static_cast<double>(count_styles(lines)),
      static_cast<double>(TactileLimits::kLineStyles));
  add(TactileRule::kAreaStyles, static_cast<double>(count_colors(parts)), 1.0);
  const auto [shorter, longer] = std::minmax({box.width(), box.height()});
  if (longer > TactileLimits::kLongMm) {
    add(TactileRule::kSize, longer, TactileLimits::kLongMm);
  } else {
    add(TactileRule::kSize, shorter, TactileLimits::kShortMm);
  }
}

void add_thin_lines(const TouchLines& lines, std::vector<TactileFault>& faults) {
  for (const TouchLine& line : lines.lines) {
    const bool is_dot = line.length_mm <= kDotWidths * std::max(line.mean_width_mm, kSmallDotMm);
    const double limit = is_dot ? TactileLimits::kDotMm : TactileLimits::kLineMm;
    if (line.mean_width_mm >= limit - kWidthToleranceMm) continue;
    const Point at = lines.points[line.first + line.count / 2].at;
    faults.push_back({TactileRule::kThinLine, at, line.mean_width_mm, limit, 0.0, line.stroke, {}});
  }
}

}  // namespace

double tactile_enlargement(const std::vector<TactileFault>& faults) noexcept {
  double needed = 1.0;
  for (const TactileFault& f : faults) {
    if (depends_on_size(f.rule)) needed = std::max(needed, f.limit / f.measured);
  }
  constexpr double kRounding = 1e-9;  // 2.2 stays 2.2
  return std::ceil(10.0 * (needed - kRounding)) / 10.0;
}

Result<std::vector<TactileFault>> check_tactile(const Document& document,
                                                const TactileLimits& limits) {
  const VisibleParts parts = visible_parts(document, limits.paper);
  const Result<TouchLines> lines = touch_lines_of(parts);
  if (!lines) return tl::unexpected(lines.error());
  std::vector<TactileFault> faults = find_line_gaps(*lines, limits.gap_mm);
  add_shape_faults(parts, *lines, faults);
  add_area_faults(parts, faults);
  add_whole_faults(parts, *lines, faults);
  add_thin_lines(*lines, faults);
  return faults;
}

}  // namespace felt
