#include "strip_middle.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "felt/geometry/polyline.h"

namespace felt::bench {
namespace {

constexpr std::size_t kSections = 200;
constexpr double kMinCosine = 0.5;

double percentile(std::vector<double> values, double share) {
  std::sort(values.begin(), values.end());
  return values[std::min(values.size() - 1,
                         static_cast<std::size_t>(share * static_cast<double>(values.size())))];
}

// Returns the offset of the nearest crossing of each line, sorted, as far as their gaps are at most
// `reach`, starting at 0.
std::vector<double> crossings(Point at, Vec along, std::span<const RoughLine> lines, double reach) {
  std::vector<double> offsets;
  for (const RoughLine& line : lines) {
    std::optional<double> nearest;
    for (std::size_t k = 0; k + 1 < line.size(); ++k) {
      const double u = dot(line[k] - at, along), v = dot(line[k + 1] - at, along);
      if ((u > 0.0) == (v > 0.0)) continue;
      if (std::fabs(dot(normalized(line[k + 1] - line[k]), along)) < kMinCosine) continue;
      const double offset = dot(lerp(line[k], line[k + 1], u / (u - v)) - at, perp(along));
      if (!nearest || std::fabs(offset) < std::fabs(*nearest)) nearest = offset;
    }
    if (nearest) offsets.push_back(*nearest);
  }
  std::sort(offsets.begin(), offsets.end());
  const auto zero = std::lower_bound(offsets.begin(), offsets.end(), 0.0);
  auto first = zero, last = zero;
  for (double edge = 0.0; last != offsets.end() && *last - edge <= reach; ++last) edge = *last;
  for (double edge = 0.0; first != offsets.begin() && edge - *std::prev(first) <= reach;) {
    edge = *--first;
  }
  return {first, last};
}

}  // namespace

std::optional<StripDistance> strip_distance(const BundlePath& path,
                                            std::span<const RoughLine> lines, double pen_width) {
  std::vector<Point> points(kSections + 1);
  resample(path.points, points);
  std::vector<double> widths, distances;
  const double reach = 2.0 * (path.strip_mm + pen_width);
  for (std::size_t k = 0; k < kSections; ++k) {
    const Vec along = normalized(points[std::min(k + 2, kSections)] - points[k > 0 ? k - 1 : 0]);
    const std::vector<double> offsets =
        crossings(lerp(points[k], points[k + 1], 0.5), along, lines, reach);
    if (offsets.size() < 2) continue;
    double sum = 0.0;
    for (const double offset : offsets) sum += offset;
    distances.push_back(std::fabs(sum / static_cast<double>(offsets.size())));
    widths.push_back(offsets.back() - offsets.front() + pen_width);
  }
  if (widths.empty()) return std::nullopt;
  StripDistance result{.width = percentile(widths, 0.5), .p95 = percentile(distances, 0.95)};
  for (const double d : distances) result.mean += d / static_cast<double>(distances.size());
  return result;
}

}  // namespace felt::bench
