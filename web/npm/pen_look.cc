#include "pen_look.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "felt/stroke/arc_map.h"
#include "felt/stroke/width_profile.h"

namespace felt::npm {
namespace {

PenTip tip_from_numbers(const double* numbers) noexcept {
  PenTip tip;
  tip.taper_mm = std::max(0.0, numbers[0]);
  tip.is_flat = numbers[1] != 0.0;
  std::copy_n(numbers + 2, tip.share.size(), tip.share.begin());
  return tip;
}

/// Returns the parameters at which the tapered profile needs a breakpoint, in order.
std::vector<double> taper_parameters(const Stroke& stroke, const ArcMap& arc, const PenLook& look) {
  std::vector<double> result;
  for (const WidthKnot& knot : stroke.widths()) result.push_back(knot.u);
  for (std::size_t i = 1; i <= PenTip::kSteps; ++i) {
    const double share = static_cast<double>(i) / PenTip::kSteps;
    const double from_start = share * look.start.taper_mm;
    const double from_end = arc.length_mm() - share * look.end.taper_mm;
    if (from_start > 0.0 && from_start < arc.length_mm()) result.push_back(arc.u_at(from_start));
    if (look.end.taper_mm > 0.0 && from_end > 0.0) result.push_back(arc.u_at(from_end));
  }
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

/// Returns the stroke with the widths of its tapered ends.
Result<Stroke> tapered(const Stroke& stroke, const PenLook& look) {
  const ArcMap arc(stroke);
  StrokeData data = stroke.data();
  data.widths.clear();
  for (const double u : taper_parameters(stroke, arc, look)) {
    const double length = arc.length_at(u);
    const double share = std::min(look.start.share_at(length),
                                  look.end.share_at(std::max(0.0, arc.length_mm() - length)));
    data.widths.push_back({u, std::max(kMinWidthMm, share * stroke.width_mm(u))});
  }
  return Stroke::create(std::move(data));
}

/// Makes the round cap at one end flat: moves the points on the circle around the end that lie
/// beyond it back onto the line through the end. `outward` is the direction in which the stroke
/// ends.
void flatten_cap(std::vector<Point>& points, Point center, double radius_mm, Vec outward) {
  for (Point& p : points) {
    const double beyond = dot(p - center, outward);
    const bool is_cap = std::fabs(distance(p, center) - radius_mm) < 1e-9 * (1.0 + radius_mm);
    if (is_cap && beyond > 0.0) p -= beyond * outward;
  }
}

}  // namespace

double PenTip::share_at(double distance_mm) const noexcept {
  if (!(distance_mm < taper_mm)) return 1.0;
  const double step = std::max(0.0, distance_mm) / taper_mm * kSteps;
  const std::size_t i = std::min(kSteps - 1, static_cast<std::size_t>(step));
  return std::lerp(share[i], share[i + 1], step - static_cast<double>(i));
}

PenLook PenLook::from_numbers(const double* numbers) noexcept {
  return {tip_from_numbers(numbers), tip_from_numbers(numbers + PenTip::kSteps + 3)};
}

Outline pen_outline(const Stroke& stroke, const PenLook& look, double tolerance_mm) {
  const bool tapers = look.start.taper_mm > 0.0 || look.end.taper_mm > 0.0;
  const Result<Stroke> changed = tapers ? tapered(stroke, look) : stroke;
  const Stroke& drawn = changed ? *changed : stroke;
  Outline outline = outline_of(drawn, tolerance_mm);
  const auto flatten = [&](StrokeTip tip, double u) {
    flatten_cap(outline.points, tip_point(drawn, tip), 0.5 * drawn.width_mm(u),
                tip_direction(drawn, tip));
  };
  if (look.start.is_flat) flatten(StrokeTip::kStart, 0.0);
  if (look.end.is_flat) flatten(StrokeTip::kEnd, drawn.segment_count());
  return outline;
}

}  // namespace felt::npm
