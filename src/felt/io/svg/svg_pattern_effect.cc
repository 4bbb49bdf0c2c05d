#include "felt/io/svg/svg_pattern_effect.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "felt/geometry/cubic.h"
#include "felt/io/ndjson/ndjson_writer.h"
#include "felt/stroke/outline/outline.h"

namespace felt {
namespace {

void append_rounded(std::string& out, double mm) {
  append_number(out, std::round(mm * 1e4) / 1e4);
}

/// Path data of the pattern are rounded, and Inkscape rounds the number of copies down. It gets
/// this share of a copy more, which it stretches away.
constexpr double kSpareCopy = 0.25;
constexpr double kLengthToleranceMm = 0.01;

/// Returns the length of the centre line in mm and in widths of the line.
std::pair<double, double> lengths_of(const Stroke& stroke) {
  std::vector<Dab> dabs;
  flatten(stroke, kLengthToleranceMm, dabs);
  double mm = 0.0, widths = 0.0;
  for (std::size_t i = 0; i + 1 < dabs.size(); ++i) {
    const double chord = distance(dabs[i].center, dabs[i + 1].center);
    mm += chord;
    widths += chord / (dabs[i].radius_mm + dabs[i + 1].radius_mm);
  }
  return {mm, widths};
}

/// Returns the length of the pattern in mm with which Inkscape makes as many copies as Feltline
/// does on a line without corners. `box` is that of the shape.
double pattern_length_mm(const Stroke& stroke, const MediumStyle& how, const Rect& box) {
  const auto [mm, widths] = lengths_of(stroke);
  if (how.kind == StyleKind::kStretch) return mm;
  const double period = how.length + how.gap, after = stroke.closed() ? 0.0 : how.gap;
  const double copies = std::max(1.0, std::round((widths + after) / period)) + kSpareCopy;
  // Inkscape: copies = (line - tang_offset [+ spacing if open]) / (width of the box + spacing).
  const double spacing = stroke.closed() ? 0.0 : how.gap + (1.0 - box.width()) * how.length;
  return mm * how.length / (copies * period + box.x0 * how.length - spacing);
}

double mean_width_mm(const Stroke& stroke) noexcept {
  const auto knots = stroke.widths();
  double sum = 0.0;
  for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
    sum += 0.5 * (knots[i].width_mm + knots[i + 1].width_mm) * (knots[i + 1].u - knots[i].u);
  }
  return sum / stroke.segment_count();
}

/// Appends the shape as path data in mm: `length_mm` long and `width_mm` wide.
void append_shape(std::string& out, const StyleShape& shape, double length_mm, double width_mm) {
  const auto point = [&](Point p) {
    out += ' ';
    append_rounded(out, length_mm * p.x);
    out += ',';
    append_rounded(out, width_mm * p.y);
  };
  for (const std::vector<Point>& contour : shape.contours) {
    out += out.ends_with('"') ? "M" : " M";
    point(contour.front());
    out += " C";
    for (std::size_t i = 1; i < contour.size(); ++i) point(contour[i]);
    out += " Z";
  }
}

Rect bounds_of(const StyleShape& shape) noexcept {
  Rect box;
  for (const std::vector<Point>& contour : shape.contours) {
    for (std::size_t i = 0; i + 3 < contour.size(); i += 3) {
      box.extend(bounds(Cubic{{contour[i], contour[i + 1], contour[i + 2], contour[i + 3]}}));
    }
  }
  return box;
}

}  // namespace

bool has_pattern_effect(const StrokeStyle* style) noexcept {
  return style &&
         (style->how.kind == StyleKind::kRepeat || style->how.kind == StyleKind::kStretch) &&
         style->how.arrows == StyleArrows::kNone;
}

// Inkscape moves the pattern's box to the start and the middle of the path, so offsets move it back
// (lpe-patternalongpath.cpp, Inkscape 1.2).
void append_pattern_effect(std::string& out, const Stroke& stroke, const StrokeStyle& style,
                           const std::string& id) {
  const double width_mm = mean_width_mm(stroke);
  const Rect box = bounds_of(style.shape);
  const double length_mm = pattern_length_mm(stroke, style.how, box);
  const bool repeats = style.how.kind == StyleKind::kRepeat;
  out += "<defs><inkscape:path-effect id=\"" + id +
         "\" effect=\"skeletal\" is_visible=\"true\" lpeversion=\"1\" copytype=\"";
  out += repeats ? "repeated_stretched" : "single_stretched";
  out +=
      "\" prop_scale=\"1\" scale_y_rel=\"false\" prop_units=\"false\" "
      "vertical_pattern=\"false\" fuse_tolerance=\"0\" spacing=\"";
  append_rounded(
      out, repeats ? (style.how.gap / style.how.length + 1.0 - box.width()) * length_mm : 0.0);
  out += "\" tang_offset=\"";
  append_rounded(out, box.x0 * length_mm);
  out += "\" normal_offset=\"";
  append_rounded(out, 0.5 * (box.y0 + box.y1) * width_mm);
  out += "\" pattern=\"";
  append_shape(out, style.shape, length_mm, width_mm);
  out += "\"/></defs>\n";
}

}  // namespace felt
