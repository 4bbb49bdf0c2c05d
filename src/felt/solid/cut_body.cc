#include "felt/solid/cut_body.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "felt/solid/body_boolean.h"
#include "felt/solid/body_parts.h"
#include "felt/solid/cut_clearance.h"
#include "felt/solid/cut_region.h"
#include "felt/solid/plane_mesh.h"
#include "felt/solid/stroke_path.h"
#include "felt/solid/view_frame.h"

namespace felt {
namespace body_cutting {

/// Largest distance of the points on the stroke, in edges of the body.
constexpr double kStepInEdges = 0.75;
/// The unit, in steps, by which the stroke is moved if points of the body lie on it: half of the
/// length below which body_boolean.h removes edges.
constexpr double kClearanceInSteps = 5e-4;
/// Parts of the body that reach less far beyond the stroke, in steps, are not cut off: more than
/// the stroke is moved, so that the same stroke cuts nothing the second time.
constexpr double kToleranceInSteps = (kMaxClearanceSteps + 1) * kClearanceInSteps;
constexpr int kMaxLevels = 40;
/// Components with a smaller share of the volume are crumbs of rounding.
constexpr double kCrumbShare = 1e-6;

/// Returns the distance of the points on a stroke across a body, rounded down to a power of
/// sqrt(2), so that a stroke that is drawn again gets the same points. Each edge counts with the
/// area of its triangles: the small triangles at earlier cuts make the next one no finer.
double step_for(const SolidBody& body) {
  double sum = 0.0, areas = 0.0;
  for (const auto& [a, b, c] : body.triangles) {
    const Vec3 u = body.points[b] - body.points[a], v = body.points[c] - body.points[a];
    const double area = norm(cross(u, v));
    areas += area;
    sum += area * (norm(u) + norm(v) + norm(v - u)) / 3.0;
  }
  if (!(areas > 0.0)) return mean_edge_mm(body);
  return std::exp2(0.5 * std::floor(2.0 * std::log2(kStepInEdges * sum / areas)));
}

/// Returns the closed prism above and below a region, deeper than the body on both sides.
Result<SolidBody> prism_of(const CutRegion& region, const ViewFrame& frame, const SolidBody& body,
                           double step_mm) {
  const Result<std::vector<SolidBody::Triangle>> cap = triangulate_ring(region.ring);
  if (!cap) return tl::unexpected(cap.error());
  double low = frame.depth(body.points.front()), high = low;
  for (const Vec3& p : body.points) {
    low = std::min(low, frame.depth(p));
    high = std::max(high, frame.depth(p));
  }
  const double margin = 0.05 * (high - low) + step_mm;
  // The levels of two cuts have different depths, so that their edges do not meet.
  constexpr double kGoldenRatio = 1.6180339887498949;
  const double turns = kGoldenRatio * static_cast<double>(body.points.size());
  const double offset = 2.0 * step_mm * (turns - std::floor(turns));
  low -= margin + offset, high += margin + 2.0 * step_mm - offset;
  const auto levels = static_cast<std::uint32_t>(
      std::clamp(static_cast<int>((high - low) / (2.0 * step_mm)), 1, kMaxLevels));
  const auto n = static_cast<std::uint32_t>(region.ring.size());
  SolidBody prism;
  for (std::uint32_t level = 0; level <= levels; ++level) {
    const double depth = low + (high - low) * level / levels;
    for (const Point p : region.ring) prism.points.push_back(frame.to_solid(p, depth));
  }
  for (std::uint32_t level = 0; level < levels; ++level) {
    for (std::uint32_t i = 0; i < n; ++i) {
      const std::uint32_t a = level * n + i, b = level * n + (i + 1) % n;
      prism.triangles.push_back({a, b, b + n});
      prism.triangles.push_back({a, b + n, a + n});
    }
  }
  for (const auto& [a, b, c] : *cap) {
    prism.triangles.push_back({levels * n + a, levels * n + b, levels * n + c});
    prism.triangles.push_back({b, a, c});
  }
  return prism;
}

}  // namespace body_cutting

Result<std::optional<std::vector<SolidBody>>> cut_body(const SolidBody& body,
                                                       std::span<const Vec3> path,
                                                       const Vec3& view) {
  using namespace body_cutting;
  using Parts = std::optional<std::vector<SolidBody>>;
  const ViewFrame frame = view_frame(view);
  std::vector<Point> stroke;
  for (const Vec3& p : path) stroke.push_back(frame.to_picture(p));
  if (stroke.size() < 2 || path_length(stroke) <= 0.0) {
    return invalid_data("the stroke has no length");
  }
  const double step_mm = step_for(body);
  Result<std::optional<CutRegion>> region = find_cut_region(body, frame, stroke, step_mm);
  if (!region) return tl::unexpected(region.error());
  if (!*region) return Parts();
  switch (cut_effect(body, frame, **region, kToleranceInSteps * step_mm)) {
    case CutEffect::kRemovesNothing:
      return Parts(std::vector{body});
    case CutEffect::kRemovesAll:
      return invalid_data("nothing of the body would remain");
    case CutEffect::kRemovesPart:
      move_off_points(body, frame, kClearanceInSteps * step_mm, **region);
  }
  const Result<SolidBody> prism = prism_of(**region, frame, body, step_mm);
  if (!prism) return tl::unexpected(prism.error());
  Result<SolidBody> rest = combine(body, *prism, BodyBoolean::kDifference);
  if (!rest) return tl::unexpected(rest.error());
  rest->stroke = body.stroke;
  rest->color = body.color;
  std::vector<SolidBody> parts = components_of(*rest);
  const double crumb = kCrumbShare * volume_mm3(body);
  std::erase_if(parts, [crumb](const SolidBody& part) { return volume_mm3(part) < crumb; });
  if (parts.empty()) return invalid_data("nothing of the body would remain");
  for (const SolidBody& part : parts) {
    if (const Result<void> sound = check_body(part, {}); !sound) {
      return invalid_data("the cut runs along the surface of the body");
    }
  }
  return Parts(std::move(parts));
}

}  // namespace felt
