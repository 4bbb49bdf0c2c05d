#include "methods.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "felt/geometry/nearest.h"
#include "felt/tools/brush_pull.h"
#include "felt/tools/pull/grab_pull.h"

namespace felt::bench {
namespace {

/// Movement of the pen per tick, mm. The paper moves the stroke in each tick of its haptic loop;
/// this is a hand at 100 mm/s and a loop at 1 kHz.
constexpr double kTickMm = 0.1;
/// Limit for "t ~ 0" and "t ~ 1" in cases 1 and 2 of the paper, which does not give a number.
constexpr double kNearJoint = 0.05;

EditWeights cases_as_printed(double t) {
  if (t < kNearJoint) return {{1.0, 1.0, 0.0, 0.0}};
  if (t > 1.0 - kNearJoint) return {{0.0, 0.0, 1.0, 1.0}};
  const double part = 1.0 / (3.0 * t * (1.0 - t));
  return {{0.0, part, part, 0.0}};
}

/// Pulls the stroke tick by tick, as the paper does. Each tick finds the point nearest to the pen
/// on the current segment and its neighbours; V is the vector from that point to the pen. Then it
/// moves the control points by their weights times V, and turns the neighbours' handles into line.
template <class Weights>
Result<StrokeData> tick_by_tick(const Pull& pull, Weights weights) {
  Strand strand(pull.stroke);
  StrandPlace place = strand.locate(pull.u);
  const Point from = pull.stroke->position(pull.u);
  const int ticks = std::max(1, static_cast<int>(std::ceil(norm(pull.way) / kTickMm)));
  for (int k = 1; k <= ticks; ++k) {
    const Point pen = from + (static_cast<double>(k) / ticks) * pull.way;
    double best = std::numeric_limits<double>::infinity();
    const int here = place.segment;
    for (const int i : {strand.previous(here), here, strand.next(here)}) {
      if (i < 0) continue;
      const Nearest near = nearest(strand.segment(i), pen);
      if (near.distance_squared >= best) continue;
      best = near.distance_squared;
      place = {i, near.t};
    }
    const Vec v = pen - evaluate(strand.segment(place.segment), place.t);
    strand.prepare(place.segment);
    if (!strand.bend(place.segment, place.t, weights(place.t), v)) {
      return fail(ErrorCode::kInvalidData, "a segment was reduced to a point");
    }
  }
  return strand.stroke().map([](const Stroke& stroke) { return stroke.data(); });
}

StrokeData dragged_point(const Pull& pull) {
  StrokeData data = pull.stroke->data();
  const Point from = pull.stroke->position(pull.u);
  std::size_t held = 0;
  for (std::size_t k = 1; k < data.points.size(); ++k) {
    if (distance(data.points[k], from) < distance(data.points[held], from)) held = k;
  }
  data.points[held] += pull.way;
  if (data.closed && held == 0) data.points.back() = data.points.front();
  return data;
}

Result<StrokeData> data_of(const Result<Stroke>& stroke) {
  return stroke.map([](const Stroke& s) { return s.data(); });
}

}  // namespace

std::string_view name_of(Method method) noexcept {
  switch (method) {
    case Method::kBrush:
      return "brush (ours)";
    case Method::kSoft:
      return "grab, soft";
    case Method::kPaper:
      return "grab, paper";
    case Method::kPrinted:
      return "eq. 7 per tick";
    case Method::kCases:
      return "cases per tick";
    case Method::kPoint:
      return "control point";
  }
  return "";
}

Result<StrokeData> pulled(Method method, const Pull& pull, double brush_radius_mm) {
  switch (method) {
    case Method::kBrush:
      return data_of(
          BrushPull(pull.stroke, pull.u, {.radius_mm = brush_radius_mm}).finished(pull.way));
    case Method::kSoft:
      return data_of(GrabPull(pull.stroke, pull.u, {}).finished(pull.way));
    case Method::kPaper:
      return data_of(
          GrabPull(pull.stroke, pull.u, {.weights = WeightKind::kPaper}).finished(pull.way));
    case Method::kPrinted:
      return tick_by_tick(pull, printed_weights);
    case Method::kCases:
      return tick_by_tick(pull, cases_as_printed);
    case Method::kPoint:
      break;
  }
  return dragged_point(pull);
}

}  // namespace felt::bench
