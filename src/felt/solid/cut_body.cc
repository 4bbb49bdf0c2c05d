#include "felt/solid/cut_body.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "felt/solid/body_boolean.h"
#include "felt/solid/body_parts.h"
#include "felt/solid/cut_region.h"
#include "felt/solid/plane_mesh.h"
#include "felt/solid/stroke_path.h"
#include "felt/solid/view_frame.h"

namespace felt {
namespace body_cutting {

/// Distance of the points on the stroke, in mean edges of the body.
constexpr double kStepInEdges = 0.8;
constexpr int kMaxLevels = 40;
/// Components with a smaller share of the volume are crumbs of rounding.
constexpr double kCrumbShare = 1e-6;

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
  low -= margin, high += margin;
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
  const double step_mm = kStepInEdges * mean_edge_mm(body);
  Result<std::optional<CutRegion>> region = find_cut_region(body, frame, stroke, step_mm);
  if (!region) return tl::unexpected(region.error());
  if (!*region) return Parts();
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
