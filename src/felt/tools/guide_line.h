#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "felt/base/result.h"
#include "felt/geometry/point.h"

namespace felt {

/// How a guide acts on the pen (docs/design/forces.md#guides).
enum class GuideKind : std::uint8_t {
  kNone,             ///< no guide
  kGroove,           ///< towards the path
  kAsNeeded,         ///< a groove that grows with the error and fades as the user does well
  kErrorAmplifying,  ///< away from the path
  kTeacher,          ///< a groove that leads the pen along the path
};

/// A path along which the pencil guides the pen.
struct GuideLine {
  GuideKind kind = GuideKind::kNone;
  std::vector<Point> points = {};  ///< mm; empty for kNone
  bool is_closed = false;          ///< the last point is joined to the first
  double strength = 1.0;           ///< 0..1, multiplies the force
  /// For kTeacher: when the teacher was at each point, ms. Otherwise empty.
  std::vector<double> times_ms = {};
  friend bool operator==(const GuideLine&, const GuideLine&) = default;
};

inline constexpr std::size_t kMaxGuidePoints = 20'000;
inline constexpr double kMinGuideMm = 1.0;       ///< shortest path
inline constexpr double kMaxGuideMm = 20'000.0;  ///< longest path

/// Fails if the guide cannot be used: too few or too many points, a coordinate or strength out of
/// range, a path shorter or longer than the limits, or times that are missing or run backwards. The
/// message starts with the key of the event (docs/formats/events.md).
Result<void> check_guide(const GuideLine& line);

}  // namespace felt
