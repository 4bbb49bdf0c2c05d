#include "felt/document/drawing_guide.h"

#include <array>
#include <cmath>
#include <string>

namespace felt {
namespace {

constexpr std::array<std::string_view, kDrawingGuideKinds> kKindNames = {
    "ruler",    "line",        "parallels", "set-square",     "protractor", "compass", "ellipse",
    "ellipses", "perspective", "grid",      "isometric-grid", "symmetry",   "trace",   "teacher"};

Result<void> check_number(const char* key, double value, double smallest, double largest) {
  if (value >= smallest && value <= largest) return {};  // false for NaN
  return fail(ErrorCode::kInvalidArgument, std::string(key) + ": is out of range");
}

Result<void> check_point(const char* key, Point p) {
  constexpr double kMax = DrawingGuide::kMaxCoordinateMm;
  return check_number(key, p.x, -kMax, kMax).and_then([&] {
    return check_number(key, p.y, -kMax, kMax);
  });
}

Result<void> check_points(const DrawingGuide& guide) {
  const std::size_t count = guide.points.size();
  const auto wrong = [](const char* what) { return fail(ErrorCode::kInvalidArgument, what); };
  switch (guide.kind) {
    case DrawingGuideKind::kPerspective:
      if (count == 0 || count > DrawingGuide::kMaxVanishingPoints) {
        return wrong("points: a perspective has one to three vanishing points");
      }
      break;
    case DrawingGuideKind::kTeacher:
      if (count < 2 || count > DrawingGuide::kMaxTeacherPoints) {
        return wrong("points: the path of a teacher has 2 to 20000 points");
      }
      break;
    default:
      if (count > 0) return wrong("points: a guide of this kind has none");
  }
  for (const Point p : guide.points) {
    if (Result<void> fine = check_point("points", p); !fine) return fine;
  }
  return {};
}

Result<void> check_times(const DrawingGuide& guide) {
  const std::size_t count =
      guide.kind == DrawingGuideKind::kTeacher ? guide.points.size() : std::size_t{0};
  if (guide.times_ms.size() != count) {
    return fail(ErrorCode::kInvalidArgument, count > 0
                                                 ? "times_ms: a teacher has one time for each point"
                                                 : "times_ms: only a teacher has times");
  }
  double last_ms = 0.0;
  for (const double ms : guide.times_ms) {
    if (!std::isfinite(ms) || ms < last_ms) {
      return fail(ErrorCode::kInvalidArgument, "times_ms: the times start before 0 or decrease");
    }
    last_ms = ms;
  }
  return {};
}

}  // namespace

std::string_view guide_kind_name(DrawingGuideKind kind) noexcept {
  return kKindNames[static_cast<std::size_t>(kind)];
}

Result<void> check_drawing_guide(const DrawingGuide& guide) {
  using G = DrawingGuide;
  if (static_cast<std::size_t>(guide.kind) >= kDrawingGuideKinds) {
    return fail(ErrorCode::kInvalidArgument, "kind: is unknown");
  }
  if (guide.axes < G::kMinAxes || guide.axes > G::kMaxAxes) {
    return fail(ErrorCode::kInvalidArgument, "axes: a symmetry has 1 to 16 axes");
  }
  if (static_cast<bool>(guide.stroke) != (guide.kind == DrawingGuideKind::kTrace)) {
    return fail(ErrorCode::kInvalidArgument,
                guide.stroke ? "stroke: only a trace has one" : "stroke: a trace needs one");
  }
  return check_point("origin", guide.origin)
      .and_then([&] {
        return check_number("angle_rad", guide.angle_rad, -G::kMaxAngleRad, G::kMaxAngleRad);
      })
      .and_then(
          [&] { return check_number("size_mm", guide.size_mm, G::kMinSizeMm, G::kMaxSizeMm); })
      .and_then(
          [&] { return check_number("second_mm", guide.second_mm, G::kMinSizeMm, G::kMaxSizeMm); })
      .and_then(
          [&] { return check_number("step_rad", guide.step_rad, G::kMinStepRad, G::kMaxStepRad); })
      .and_then([&] { return check_number("strength", guide.strength, 0.0, 1.0); })
      .and_then([&] { return check_points(guide); })
      .and_then([&] { return check_times(guide); });
}

}  // namespace felt
