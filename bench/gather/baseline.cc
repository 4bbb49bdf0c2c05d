#include "baseline.h"

#include <cmath>
#include <numeric>

#include "felt/geometry/polyline.h"

namespace felt::bench {
namespace {

constexpr std::size_t kSamples = 33;
constexpr double kDistanceShare = 0.009;
const double kMinCosine = std::cos(20.0 * 3.14159265358979323846 / 180.0);

Vec direction_at(const RoughLine& line, std::size_t k) {
  const std::size_t last = line.size() - 1;
  return normalized(line[k < last ? k + 1 : last] - line[k > 0 ? k - 1 : 0]);
}

bool lies_beside(const RoughLine& line, const RoughLine& other, double distance) {
  std::size_t near = 0;
  for (std::size_t k = 0; k < line.size(); ++k) {
    const PolylineNearest at = nearest_on_polyline(other, line[k]);
    if (at.distance_squared > distance * distance) continue;
    const Vec along = normalized(other[std::min(at.index + 1, other.size() - 1)] - other[at.index]);
    if (std::fabs(dot(along, direction_at(line, k))) >= kMinCosine) ++near;
  }
  return 2 * near >= line.size();
}

}  // namespace

std::vector<std::uint32_t> baseline_groups(const LabelledDrawing& drawing) {
  const double distance = kDistanceShare * drawing.diagonal();
  std::vector<RoughLine> lines(drawing.lines.size(), RoughLine(kSamples));
  for (std::size_t i = 0; i < lines.size(); ++i) resample(drawing.lines[i], lines[i]);
  std::vector<std::uint32_t> groups(lines.size());
  std::iota(groups.begin(), groups.end(), 0U);
  for (std::uint32_t i = 0; i < lines.size(); ++i) {
    for (std::uint32_t k = 0; k < lines.size(); ++k) {
      if (groups[i] == groups[k] || !lies_beside(lines[i], lines[k], distance)) continue;
      const std::uint32_t old = groups[k];
      for (std::uint32_t& group : groups) group = group == old ? groups[i] : group;
    }
  }
  return groups;
}

}  // namespace felt::bench
