#include "felt/tools/guide_line.h"

#include <string>

#include "felt/geometry/polyline.h"

namespace felt {
namespace {

tl::unexpected<Error> refuse(const std::string& reason) {
  return fail(ErrorCode::kInvalidArgument, reason);
}

Result<void> check_times(const GuideLine& line) {
  if (line.kind != GuideKind::kTeacher) {
    if (line.times_ms.empty()) return {};
    return refuse("times_ms: only a guide of the kind \"teacher\" has times");
  }
  if (line.is_closed) return refuse("closed: the path of a teacher is not closed");
  if (line.times_ms.size() != line.points.size()) {
    return refuse("times_ms: has " + std::to_string(line.times_ms.size()) + " times for " +
                  std::to_string(line.points.size()) + " points");
  }
  for (std::size_t i = 0; i < line.times_ms.size(); ++i) {
    const std::string key = "times_ms[" + std::to_string(i) + "]: ";
    if (!(line.times_ms[i] >= 0.0 && line.times_ms[i] <= 1e9)) {
      return refuse(key + "is not from 0 to 1e9");
    }
    if (i > 0 && line.times_ms[i] < line.times_ms[i - 1]) {
      return refuse(key + "is before the time of the previous point");
    }
  }
  return {};
}

}  // namespace

Result<void> check_guide(const GuideLine& line) {
  if (!(line.strength >= 0.0 && line.strength <= 1.0)) {
    return refuse("strength: is not from 0 to 1");
  }
  if (line.kind == GuideKind::kNone) {
    if (line.points.empty() && line.times_ms.empty()) return {};
    return refuse("points: a guide of the kind \"none\" has no points");
  }
  if (line.points.size() < 2 || line.points.size() > kMaxGuidePoints) {
    return refuse("points: a guide has 2 to " + std::to_string(kMaxGuidePoints) +
                  " points, but there are " + std::to_string(line.points.size()));
  }
  for (std::size_t i = 0; i < line.points.size(); ++i) {
    if (!is_in_range(line.points[i])) {
      return refuse("points[" + std::to_string(i) + "]: a coordinate exceeds 1e9 mm");
    }
  }
  double length = polyline_length(line.points);
  if (line.is_closed) length += distance(line.points.back(), line.points.front());
  if (!(length >= kMinGuideMm && length <= kMaxGuideMm)) {
    return refuse("points: the length of the path is not from 1 mm to 20 m");
  }
  return check_times(line);
}

}  // namespace felt
