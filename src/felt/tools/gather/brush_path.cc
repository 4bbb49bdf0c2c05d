#include "felt/tools/gather/brush_path.h"

#include <algorithm>
#include <cmath>

#include "felt/document/stroke_index.h"
#include "felt/geometry/polyline.h"

namespace felt {
namespace {

constexpr double kPointShare = 1.0 / 8.0;  // of the radius: distance of the points of a stroke
constexpr double kMinPointsPerSegment = 4.0, kMaxPoints = 4000.0;  // the latter of a stroke
constexpr double kMaxBrushNodes = 200.0;  // within one sample: farther than a hand moves

}  // namespace

bool BrushPath::move(Point pen, const Scene& scene) {
  const Point from = nodes_.back();
  const double way_mm = distance(from, pen);
  const double step_mm = std::max(kStepShare * radius_mm_, way_mm / kMaxBrushNodes);
  const double steps = std::floor(way_mm / step_mm);
  for (double i = 1.0; i <= steps; ++i) step_to(lerp(from, pen, i * step_mm / way_mm), scene);
  return steps > 0.0;
}

void BrushPath::step_to(Point node, const Scene& scene) {
  const Point from = nodes_.back();
  if (nodes_.size() > kDirectionSteps) nodes_.erase(nodes_.begin());
  nodes_.push_back(node);
  direction_ = normalized(node - nodes_.front());
  if (direction_ == Vec{}) direction_ = normalized(node - from);
  Rect around;
  around.extend(from);
  around.extend(node);
  for (const StrokeId id : scene.index.strokes_in(around.inflated(radius_mm_))) {
    auto [at, is_new] = strokes_.try_emplace(id);
    if (is_new) at->second = sampled(scene, id);
    BrushedStroke& brushed = at->second;
    for (std::size_t i = 0; i < brushed.points.size(); ++i) {
      const double cosine = dot(brushed.directions[i], direction_);
      if (std::fabs(cosine) < kMinCosine) continue;
      if (nearest_on_line(from, node, brushed.points[i]).distance_squared >
          radius_mm_ * radius_mm_) {
        continue;
      }
      const double step_mm = distance(from, node);
      brushed.along_mm[i] += step_mm;
      brushed.sense_mm[i] += std::copysign(step_mm, cosine);
    }
  }
}

BrushedStroke BrushPath::sampled(const Scene& scene, StrokeId id) const {
  BrushedStroke result;
  result.stroke = scene.document.find(id);
  result.layer = scene.document.layer_of(id);
  const Stroke& stroke = *result.stroke;
  double whole_mm = 0.0;
  for (int i = 0; i < stroke.segment_count(); ++i) whole_mm += control_length(stroke.segment(i));
  const double step_mm = std::max(kPointShare * radius_mm_, whole_mm / kMaxPoints);
  for (int i = 0; i < stroke.segment_count(); ++i) {
    const Cubic segment = stroke.segment(i);
    const double count =
        std::max(kMinPointsPerSegment, std::ceil(control_length(segment) / step_mm));
    for (double k = 0.0; k < count; ++k) {
      result.us.push_back(i + k / count);
      result.points.push_back(evaluate(segment, k / count));
    }
  }
  if (!stroke.closed()) {
    result.us.push_back(stroke.segment_count());
    result.points.push_back(stroke.position(stroke.segment_count()));
  }
  const auto n = static_cast<std::ptrdiff_t>(result.points.size());
  const auto point = [&](std::ptrdiff_t i) {
    const std::ptrdiff_t at =
        stroke.closed() ? (i + n) % n : std::clamp<std::ptrdiff_t>(i, 0, n - 1);
    return result.points[static_cast<std::size_t>(at)];
  };
  for (std::ptrdiff_t i = 0; i < n; ++i) {
    result.directions.push_back(normalized(point(i + 2) - point(i - 2)));
  }
  result.along_mm.assign(result.points.size(), 0.0);
  result.sense_mm.assign(result.points.size(), 0.0);
  return result;
}

}  // namespace felt
