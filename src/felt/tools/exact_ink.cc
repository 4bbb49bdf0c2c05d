#include "felt/tools/exact_ink.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "felt/base/constants.h"
#include "felt/document/edit_builder.h"
#include "felt/geometry/nearest.h"
#include "felt/stroke/edit/join.h"
#include "felt/tools/junctions.h"

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

/// Returns the position on the shape nearest to a point; on an ellipse, the turn nearest to `at`.
double position_near(const GuideShape& shape, Point p, double at) {
  const double found = nearest_on(shape, p).at;
  const bool turns = std::holds_alternative<GuideEllipse>(shape);
  return turns ? at + std::remainder(found - at, kTau) : found;
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

Point nearest_point(const Stroke& stroke, Point p) {
  Point best = stroke.position(0.0);
  for (int i = 0; i < stroke.segment_count(); ++i) {
    const Point on = nearest(stroke.segment(i), p).point;
    if (distance_squared(on, p) < distance_squared(best, p)) best = on;
  }
  return best;
}

/// Returns the end of a stroke that is at a point.
std::optional<StrokeTip> tip_at(const Stroke& stroke, Point p) {
  for (const StrokeTip tip : {StrokeTip::kStart, StrokeTip::kEnd}) {
    if (!stroke.closed() && distance(tip_point(stroke, tip), p) <= kSharedPointMm) return tip;
  }
  return {};
}

/// Returns a point where the shape crosses the stroke, near a point of the stroke: the limit of
/// nearest points on one and the other in turn, if they do not run beside each other.
std::optional<Point> crossing(const GuideShape& shape, const Stroke& stroke, Point near) {
  constexpr int kCrossingSteps = 60;
  constexpr double kMeetMm = 1e-6, kMaxAwayMm = 3.0;
  Point on = near;
  for (int i = 0; i < kCrossingSteps; ++i) {
    const Point p = nearest_on(shape, on).point;
    on = nearest_point(stroke, p);
    if (distance(p, near) > kMaxAwayMm) return {};
    if (distance(p, on) < kMeetMm) return p;
  }
  return {};
}

/// Returns where the exact curve is to end so that it stays on the lines on which it ends.
ExactEnds ends_on_lines(const Document& document, const Stroke& drawn, const ExactPath& path,
                        const std::vector<Junction>& junctions) {
  ExactEnds ends;
  for (const Junction& junction : junctions) {
    const Stroke& other = *document.find(junction.other);
    const std::optional<StrokeTip> tip = tip_at(drawn, junction.point);
    if (!tip || tip_at(other, junction.point)) continue;  // that end moves along
    std::optional<Point>& end = *tip == StrokeTip::kStart ? ends.start : ends.end;
    if (!end) end = crossing(path.shape, other, junction.point);
  }
  return ends;
}

/// Returns true if the exact curve ends on the middle of another line, as the drawn stroke does at
/// a point.
bool ends_on(const Stroke& other, Point drawn_end, const ExactOffer& offer) {
  const std::optional<StrokeTip> own = tip_at(*offer.drawn, drawn_end);
  if (!own || offer.exact->closed()) return false;
  const Point end = tip_point(*offer.exact, *own);
  return distance(nearest_point(other, end), end) <= kSharedPointMm;
}

/// Moves the end of another line that lies on the drawn stroke. Fails if it cannot move.
Result<Stroke> with_end_on(const Stroke& other, StrokeTip tip, const ExactOffer& offer) {
  const Point from = tip_point(other, tip);
  const std::optional<StrokeTip> own = tip_at(*offer.drawn, from);
  const bool meets_end = own && !offer.exact->closed();
  const Point to = meets_end ? tip_point(*offer.exact, *own) : nearest_point(*offer.exact, from);
  if (to == from) return other;
  const double fade_mm = std::clamp(5.0 * distance(from, to), 2.0, kTipFadeMm);
  return with_tip_at(other, tip, to, fade_mm);
}

}  // namespace

std::optional<Stroke> exact_stroke(const Stroke& drawn, const ExactPath& path,
                                   const ExactEnds& ends) {
  const Follow at = follow(drawn, path);
  const double from =
      ends.start ? position_near(path.shape, *ends.start, at.at.front()) : at.at.front();
  double to = ends.end ? position_near(path.shape, *ends.end, at.at.back()) : at.at.back();
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

std::optional<ExactOffer> offer_exact_ink(const Document& document, const StrokeIndex& index,
                                          StrokeId id, const ExactPath& path) {
  const StrokePtr drawn = document.find(id);
  if (!drawn) return {};
  const std::vector<Junction> junctions = junctions_of(document, index, id, *drawn);
  std::optional<Stroke> exact =
      exact_stroke(*drawn, path, ends_on_lines(document, *drawn, path, junctions));
  if (!exact) return {};
  ExactOffer offer{id, drawn, std::make_shared<const Stroke>(*std::move(exact))};
  if (exact_edit(document, index, offer).empty()) return {};
  return offer;
}

Edit exact_edit(const Document& document, const StrokeIndex& index, const ExactOffer& offer) {
  const SymmetryId group = document.symmetry_of(offer.id);
  std::map<StrokeId, StrokePtr> others;
  for (const Junction& junction : junctions_of(document, index, offer.id, *offer.drawn)) {
    StrokePtr& other =
        others.try_emplace(junction.other, document.find(junction.other)).first->second;
    const std::optional<StrokeTip> tip = tip_at(*other, junction.point);
    if (!tip) {
      if (!ends_on(*other, junction.point, offer)) return {};
      continue;
    }
    Result<Stroke> moved = with_end_on(*other, *tip, offer);
    if (!moved) return {};
    if (*moved == *other) continue;
    // An image of the stroke itself follows the stroke, and cannot be moved on its own.
    if (!junction.editable || (group && document.symmetry_of(junction.other) == group)) return {};
    other = std::make_shared<const Stroke>(*std::move(moved));
  }
  EditBuilder edit(document);
  edit.replace(offer.id, offer.exact);
  for (const auto& [id, stroke] : others) {
    if (stroke != document.find(id)) edit.replace(id, stroke);
  }
  return std::move(edit).build("Make exact");
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
