#include "felt/tools/exact_ink.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "felt/base/constants.h"

namespace felt {
namespace {

constexpr double kMaxArcRad = kTau / 12.0;
constexpr int kStepsPerSegment = 8;    // at which the positions of a drawn stroke are followed
constexpr double kMinKnotStep = 1e-6;  // of u, between knots of the width

/// A position on the shape for each step along the drawn stroke.
struct Follow {
  std::vector<double> u, at;
};

/// Returns the positions on the shape along the drawn stroke. Those of an ellipse count on.
Follow follow(const Stroke& drawn, const ExactPath& path) {
  Follow out;
  const bool turns = std::holds_alternative<GuideEllipse>(path.shape);
  double last = path.from;
  for (int i = 0; i <= kStepsPerSegment * drawn.segment_count(); ++i) {
    const double u = static_cast<double>(i) / kStepsPerSegment;
    double at = nearest_on(path.shape, drawn.position(u)).at;
    if (turns) at = last + std::remainder(at - last, kTau);
    last = at;
    out.u.push_back(u);
    out.at.push_back(at);
  }
  return out;
}

/// Returns the position at a parameter of the drawn stroke, interpolated.
double position_at(const Follow& follow, double u) {
  const double x = std::clamp(u * kStepsPerSegment, 0.0, static_cast<double>(follow.at.size() - 1));
  const auto i = std::min(static_cast<std::size_t>(x), follow.at.size() - 2);
  return std::lerp(follow.at[i], follow.at[i + 1], x - static_cast<double>(i));
}

/// Returns the widths of the drawn stroke on a curve with `count` segments from `from` to `to`.
std::vector<WidthKnot> widths_on(const Stroke& drawn, const Follow& follow, double from, double to,
                                 int count) {
  std::vector<WidthKnot> widths;
  const double end = count;
  for (const WidthKnot& knot : drawn.widths()) {
    double u = end * (position_at(follow, knot.u) - from) / (to - from);
    if (widths.empty()) u = 0.0;
    // A knot that is not after the previous one is where the pen went back a little.
    if (!widths.empty() && !(u > widths.back().u + kMinKnotStep)) continue;
    if (u > end - kMinKnotStep) break;
    widths.push_back({u, knot.width_mm, knot.tone});
  }
  const WidthKnot& last = drawn.widths().back();
  widths.push_back({end, last.width_mm, last.tone});
  return widths;
}

void add_segment(StrokeData& data, const GuideStraight& line, double from, double to) {
  const Cubic curve = straight(point_at(line, from), point_at(line, to));
  data.points.insert(data.points.end(), curve.p.begin() + 1, curve.p.end());
}

/// Adds the affine image of the cubic of a circular arc.
void add_segment(StrokeData& data, const GuideEllipse& e, double from, double to) {
  const double handle = 4.0 / 3.0 * std::tan(0.25 * (to - from));
  const auto velocity = [&](double at) {  // derivative of the position
    const Vec axis{std::cos(e.angle_rad), std::sin(e.angle_rad)};
    return -e.a_mm * std::sin(at) * axis + e.b_mm * std::cos(at) * perp(axis);
  };
  const Point end = point_at(e, to);
  data.points.push_back(point_at(e, from) + handle * velocity(from));
  data.points.push_back(end - handle * velocity(to));
  data.points.push_back(end);
}

int segments_of(const GuideStraight& /*line*/, double /*sweep*/) {
  return 1;
}
int segments_of(const GuideEllipse& /*ellipse*/, double sweep) {
  return std::max(1, static_cast<int>(std::ceil(std::fabs(sweep) / kMaxArcRad - 1e-9)));
}

}  // namespace

std::optional<Stroke> exact_stroke(const Stroke& drawn, const ExactPath& path) {
  const Follow at = follow(drawn, path);
  const double from = at.at.front();
  double to = at.at.back();
  const auto* ellipse = std::get_if<GuideEllipse>(&path.shape);
  const bool closes = drawn.closed();
  if (closes && (!ellipse || std::fabs(to - from) < 0.5 * kTau)) return {};
  if (closes) to = from + std::copysign(kTau, to - from);
  const double length_mm =
      std::fabs(to - from) * (ellipse ? std::min(ellipse->a_mm, ellipse->b_mm) : 1.0);
  if (!(length_mm >= kMinExactMm)) return {};
  StrokeData data;
  data.medium = drawn.medium();
  data.color = drawn.color();
  data.closed = closes;
  data.points = {point_at(path.shape, from)};
  const int count =
      std::visit([&](const auto& s) { return segments_of(s, to - from); }, path.shape);
  for (int i = 0; i < count; ++i) {
    const double a = std::lerp(from, to, double(i) / count);
    const double b = std::lerp(from, to, double(i + 1) / count);
    std::visit([&](const auto& s) { add_segment(data, s, a, b); }, path.shape);
  }
  if (closes) data.points.back() = data.points.front();
  data.joints.assign(static_cast<std::size_t>(closes ? count : count - 1), JointKind::kSmooth);
  data.widths = widths_on(drawn, at, from, to, count);
  Result<Stroke> exact = Stroke::create(std::move(data));
  if (!exact) return {};
  return *std::move(exact);
}

void draw_exact(const Stroke& exact, Overlay& overlay) {
  constexpr int kPointsPerSegment = 8;
  Overlay::Outline line{.points = {}, .closed = exact.closed(), .role = Overlay::Role::kGuide};
  for (int i = 0; i <= kPointsPerSegment * exact.segment_count(); ++i) {
    line.points.push_back(exact.position(static_cast<double>(i) / kPointsPerSegment));
  }
  if (!exact.closed()) {
    overlay.dots.push_back({line.points.front(), Overlay::Role::kGuide});
    overlay.dots.push_back({line.points.back(), Overlay::Role::kGuide});
  }
  overlay.outlines.push_back(std::move(line));
}

}  // namespace felt
