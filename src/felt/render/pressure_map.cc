#include "felt/render/pressure_map.h"

#include <algorithm>
#include <cmath>

#include "felt/render/grain.h"
#include "felt/render/segment_runs.h"

namespace felt {
namespace {

/// Steps along the stroke, in shares of the tip's radius: the edge deviates by 1 % of it.
constexpr double kStepOfRadius = 0.25;
constexpr double kShortestStepPx = 0.7;

/// Share of the pressure that is left at the edge of the tip.
constexpr double kAtEdge = 0.55;

}  // namespace

void PressureMap::begin(PixelRect area) {
  area_ = area;
  values_.assign(static_cast<std::size_t>(area.width()) * static_cast<std::size_t>(area.height()),
                 0.0F);
}

void PressureMap::make(const Stroke& stroke, const View& view, PixelRect area) {
  begin(area);
  const Rect near = view.area_mm({area.x0 - 2.0, area.y0 - 2.0}, {area.x1 + 2.0, area.y1 + 2.0});
  for (int i = 0; i < stroke.segment_count(); ++i) {
    const Cubic c = stroke.segment(i);
    if (!near.intersects(segment_area(stroke, i))) continue;
    // The control polygon is at least as long as the curve.
    double length_px = 0.0, thinnest_px = 1e300;
    for (std::size_t k = 1; k < 4; ++k) {
      length_px += view.px_per_mm * distance(c.p[k - 1], c.p[k]);
    }
    for (int k = 0; k <= 8; ++k) {
      thinnest_px = std::min(thinnest_px, view.px_per_mm * stroke.width_mm(i + 0.125 * k));
    }
    const double step_px = std::max(kShortestStepPx, 0.5 * kStepOfRadius * thinnest_px);
    const double steps = std::clamp(std::ceil(1.5 * length_px / step_px), 1.0, 1e6);
    for (double k = 0; k <= steps; ++k) {
      const double t = k / steps;
      const double width = stroke.width_mm(i + t);
      const Vec at = view.to_px(evaluate(c, t));
      press(at, 0.5 * view.px_per_mm * width, pressure_of_width(width));
    }
  }
}

void PressureMap::press(Vec center_px, double radius_px, double pressure) {
  const double radius = radius_px + 1.0;  // the outermost pixels are inked in part
  if (!(center_px.x + radius > area_.x0 && center_px.x - radius < area_.x1 &&
        center_px.y + radius > area_.y0 && center_px.y - radius < area_.y1)) {
    return;
  }
  const auto first = [](double from, int least) {
    return std::max(least, static_cast<int>(std::floor(std::max(from, least - 1.0))));
  };
  const auto past = [](double to, int most) {
    return std::min(most, static_cast<int>(std::ceil(std::min(to, most + 1.0))));
  };
  const int y1 = past(center_px.y + radius, area_.y1), x1 = past(center_px.x + radius, area_.x1);
  for (int y = first(center_px.y - radius, area_.y0); y < y1; ++y) {
    const double dy = y + 0.5 - center_px.y;
    for (int x = first(center_px.x - radius, area_.x0); x < x1; ++x) {
      const double dx = x + 0.5 - center_px.x;
      const double share = (dx * dx + dy * dy) / (radius * radius);
      if (share > 1.0) continue;
      float& value =
          values_[static_cast<std::size_t>(y - area_.y0) * static_cast<std::size_t>(area_.width()) +
                  static_cast<std::size_t>(x - area_.x0)];
      value = std::max(value, static_cast<float>(pressure * (1.0 - (1.0 - kAtEdge) * share)));
    }
  }
}

}  // namespace felt
