#include "felt/stroke/fit/guide_curve.h"

#include <algorithm>
#include <array>

#include "felt/geometry/polyline.h"
#include "felt/stroke/fit/curve_fitter.h"

namespace felt {
namespace {

Point place_at(const FittedCurve& curve, double u) {
  const int i = std::clamp(static_cast<int>(u), 0, curve.segment_count() - 1);
  return evaluate(curve.segment(i), u - i);
}

/// Returns true if the line comes within the limit of p. Tests the piece `likely` first.
bool comes_near(std::span<const Point> line, std::size_t likely, Point p, double limit_squared) {
  const std::size_t pieces = line.empty() ? 0 : line.size() - 1;
  if (pieces == 0) return !line.empty() && distance_squared(line[0], p) <= limit_squared;
  const auto piece_is_near = [&](std::size_t i) {
    return nearest_on_line(line[i], line[i + 1], p).distance_squared <= limit_squared;
  };
  likely = std::min(likely, pieces - 1);
  if (piece_is_near(likely)) return true;
  for (std::size_t i = 0; i < pieces; ++i) {
    if (i != likely && piece_is_near(i)) return true;
  }
  return false;
}

/// Returns true if the line comes within the limit of each of the points. The points are expected
/// to advance along the line in step with its vertices.
bool comes_near_all(std::span<const Point> line, std::span<const Point> points,
                    double limit_squared) {
  for (std::size_t k = 0; k < points.size(); ++k) {
    if (!comes_near(line, k, points[k], limit_squared)) return false;
  }
  return true;
}

}  // namespace

void GuideCurve::follow(const KeptSamples& kept, const FittedCurve& curve) {
  places_.clear();
  std::size_t sample = 0;
  for (std::size_t i = 0; i < kept.size(); ++i) {
    const double u = curve.sample_u[sample];
    sample += kept.sample_count(i);
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

bool GuideCurve::is_close_between(std::size_t from, std::size_t to, std::span<const Point> stretch,
                                  double limit_mm) const noexcept {
  const double limit = limit_mm * limit_mm;
  std::array<Point, kPlaces + 1> mine;
  for (std::size_t k = 0; k <= kPlaces; ++k) mine[k] = places_[kPlaces * from + k * (to - from)];
  return comes_near_all(mine, stretch, limit) && comes_near_all(stretch, mine, limit);
}

}  // namespace felt
