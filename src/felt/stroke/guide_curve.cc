#include "felt/stroke/guide_curve.h"

#include <algorithm>

#include "felt/geometry/polyline.h"
#include "felt/stroke/curve_fitter.h"

namespace felt {
namespace {

Point place_at(const FittedCurve& curve, double u) {
  const int i = std::clamp(static_cast<int>(u), 0, curve.segment_count() - 1);
  return evaluate(curve.segment(i), u - i);
}

}  // namespace

void GuideCurve::follow(const SampleWindow& window, const FittedCurve& curve) {
  places_.clear();
  std::size_t sample = 0;
  for (std::size_t i = 0; i < window.size(); ++i) {
    const double u = curve.sample_u[sample];
    sample += window.sample_count(i);
    const double next = sample < curve.sample_u.size() ? curve.sample_u[sample] : u;
    for (std::size_t k = 0; k < kPlaces; ++k) {
      const double part = static_cast<double>(k) / static_cast<double>(kPlaces);
      places_.push_back(place_at(curve, u + part * (next - u)));
    }
  }
}

bool GuideCurve::is_close_at(std::size_t i, Point p, double limit_mm) const noexcept {
  return distance_squared(places_[kPlaces * i], p) <= limit_mm * limit_mm;
}

bool GuideCurve::is_close_before(std::size_t i, std::span<const Point> stretch,
                                 double limit_mm) const noexcept {
  const double limit = limit_mm * limit_mm;
  const std::span<const Point> mine(&places_[kPlaces * (i - 1)], kPlaces + 1);
  const auto is_near = [limit](std::span<const Point> line) {
    return
        [line, limit](Point p) { return nearest_on_polyline(line, p).distance_squared <= limit; };
  };
  return std::all_of(stretch.begin(), stretch.end(), is_near(mine)) &&
         std::all_of(mine.begin(), mine.end(), is_near(stretch));
}

}  // namespace felt
