#include <algorithm>
#include <cmath>

#include "felt/geometry/polyline.h"
#include "felt/trial/trial_parts.h"

namespace felt {
namespace {

// The discrete Fréchet distance by dynamic programming, one row at a time (Eiter, Mannila,
// "Computing discrete Fréchet distance", CD-TR 94/64, TU Wien, 1994,
// https://www.kr.tuwien.ac.at/staff/eiter/et-archive/files/cdtr9464.pdf). Requires points.
double discrete_frechet(std::span<const Point> a, std::span<const Point> b) {
  std::vector<double> row(b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    double diagonal = i > 0 ? row[0] : 0.0;  // of the previous row, one to the left
    for (std::size_t j = 0; j < b.size(); ++j) {
      double reach = 0.0;
      if (i > 0 && j > 0) {
        reach = std::min({row[j], row[j - 1], diagonal});
      } else if (i > 0) {
        reach = row[0];
      } else if (j > 0) {
        reach = row[j - 1];
      }
      diagonal = row[j];
      row[j] = std::max(reach, distance_squared(a[i], b[j]));
    }
  }
  return std::sqrt(row.back());
}

// The path, beginning at the point nearest to the beginning of the ink if it is closed.
std::vector<Point> path_from_ink(const TrialPath& path, Point first) {
  const std::span line = path.line();
  if (!path.closed()) return {line.begin(), line.end()};
  const PolylineNearest at = path.nearest(first);
  std::vector<Point> out{at.point};
  const std::size_t count = line.size() - 1;
  for (std::size_t i = 1; i <= count; ++i) out.push_back(line[(at.index + i) % count]);
  out.push_back(at.point);
  return out;
}

}  // namespace

void measure_frechet(const TrialInk& ink, const TrialPath& path, TrialMetrics& metrics) {
  const double length = std::max(path.length_mm(), polyline_length(ink.points));
  const double wanted = std::ceil(length / kPathStepMm - 1e-9) + 1.0;
  const auto count = static_cast<std::size_t>(std::clamp(wanted, 2.0, double{kMaxFrechetPoints}));
  std::vector<Point> a(count), b(count);
  resample(ink.points, a);
  resample(path_from_ink(path, ink.points.front()), b);
  const double forward = discrete_frechet(a, b);
  std::reverse(b.begin(), b.end());
  metrics.frechet_mm = std::min(forward, discrete_frechet(a, b));
}

}  // namespace felt
