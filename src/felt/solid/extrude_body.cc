#include "felt/solid/extrude_body.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "felt/geometry/triangle_tree.h"
#include "felt/solid/body_boolean.h"
#include "felt/solid/body_parts.h"
#include "felt/solid/plane_mesh.h"
#include "felt/solid/stroke_path.h"
#include "felt/solid/surface_hit.h"
#include "felt/solid/view_frame.h"

namespace felt {
namespace body_extrusion {

constexpr int kMinRing = 24, kMaxRing = 96, kMinLevels = 6, kMaxLevels = 60;
/// The tip of the tube: rings end where they are narrower than this share of the base.
constexpr double kTipShare = 0.08;
/// A profile must be this high, as a share of the width of the ring.
constexpr double kMinHeightShare = 0.05;
/// How far the tube reaches into the body: this share of the thickness below the ring, but at most
/// this share of the width of the ring.
constexpr double kDepthOfThickness = 0.5, kDepthOfWidth = 0.25;

/// The base ring on the body, and the frame in which the profile lies: its origin is the middle of
/// the ring, n its normal, u the direction from the start of the profile to its end, v = n x u.
struct Base {
  std::vector<Vec3> ring;
  Vec3 middle, n, u{}, v{};
  double low = 0.0, high = 0.0;  // range of the ring along u

  [[nodiscard]] double width() const { return high - low; }
  [[nodiscard]] Vec3 at(double along_u, double along_n) const {
    return middle + along_u * u + along_n * n;
  }
};

/// Sets the axes u and v of a base for a profile.
Result<void> set_axes(Base& base, std::span<const Vec3> profile) {
  if (profile.size() < 3) return invalid_data("the profile has too few points");
  Vec3 across = profile.back() - profile.front();
  across = across - dot(across, base.n) * base.n;
  if (!(norm(across) > 0.0)) return invalid_data("the profile begins and ends at the same point");
  base.u = (1.0 / norm(across)) * across;
  base.v = cross(base.n, base.u);
  base.low = std::numeric_limits<double>::infinity();
  base.high = -base.low;
  for (const Vec3& p : base.ring) {
    base.low = std::min(base.low, dot(base.u, p - base.middle));
    base.high = std::max(base.high, dot(base.u, p - base.middle));
  }
  return {};
}

/// Returns the profile in the frame (u, n), scaled so that it begins at (low, 0) and ends at (high,
/// 0).
Result<std::vector<Point>> fitted_profile(const Base& base, std::span<const Vec3> profile) {
  std::vector<Point> flat;
  for (const Vec3& p : profile) {
    flat.push_back({dot(base.u, p - base.middle), dot(base.n, p - base.middle)});
  }
  const Point first = flat.front(), last = flat.back();
  const double span = last.x - first.x, scale = base.width() / span;
  double height = 0.0, depth = 0.0;
  for (Point& p : flat) {
    const double ground = first.y + (p.x - first.x) / span * (last.y - first.y);
    p = {base.low + scale * (p.x - first.x), scale * (p.y - ground)};
    height = std::max(height, p.y);
    depth = std::max(depth, -p.y);
  }
  if (depth > height) return invalid_data("the profile leads into the body");
  if (height < kMinHeightShare * base.width()) return invalid_data("the profile is too flat");
  return flat;
}

/// Both sides of a profile, divided into the same number of parts.
struct Sides {
  std::vector<Point> left, right;  // from the base to the tip, which is not among them
  Point tip;
};

/// The tip is the point of the profile that is farthest from the base.
Sides sides_of(const std::vector<Point>& profile, double edge_mm) {
  const Point foot = lerp(profile.front(), profile.back(), 0.5);
  const auto farther = [foot](Point a, Point b) { return distance(a, foot) < distance(b, foot); };
  const auto top = static_cast<std::size_t>(
      std::max_element(profile.begin() + 1, profile.end() - 1, farther) - profile.begin());
  const std::vector<Point> there(profile.begin(),
                                 profile.begin() + static_cast<std::ptrdiff_t>(top) + 1);
  const std::vector<Point> back(profile.rbegin(),
                                profile.rend() - static_cast<std::ptrdiff_t>(top));
  const double length = std::max(path_length(there), path_length(back));
  const int levels = std::clamp(static_cast<int>(length / edge_mm), kMinLevels, kMaxLevels);
  Sides sides;
  sides.tip = profile[top];
  sides.left = resampled(there, path_length(there) / levels);
  sides.right = resampled(back, path_length(back) / levels);
  sides.left.resize(std::min(sides.left.size(), sides.right.size()) - 1);
  sides.right.resize(sides.left.size());
  return sides;
}

/// Returns how far the tube can reach into the body without leaving it elsewhere, in mm.
Result<double> depth_below(const SolidBody& body, const Base& base) {
  double depth = kDepthOfWidth * base.width();
  const double start = 1e-4 * base.width();
  for (const Vec3& p : base.ring) {
    const auto exit = first_hit(body, p - start * base.n, -1.0 * base.n, HitSide::kLeaves);
    const auto entry = first_hit(body, p - start * base.n, -1.0 * base.n, HitSide::kEnters);
    if (!exit || (entry && entry->distance < exit->distance)) {
      return invalid_data("the closed line bends around the body too far");
    }
    depth = std::min(depth, kDepthOfThickness * exit->distance);
  }
  if (depth < 0.01 * base.width())
    return invalid_data("the body is too thin below the closed line");
  return depth;
}

/// Builds the tube.
class Tube {
 public:
  explicit Tube(const Base& base) : base_(base) {}

  Result<SolidBody> run(const Sides& sides, double depth_mm);

 private:
  void add_level(Point left, Point right, double flatness);
  void close_tip(Point tip);

  const Base& base_;
  SolidBody tube_;
};

/// Adds a copy of the ring whose width reaches from `left` to `right`. `flatness` 1 makes it plane.
void Tube::add_level(Point left, Point right, double flatness) {
  const double width = distance(left, right), scale = width / base_.width();
  const Vec across = (1.0 / width) * (right - left), along = perp(across);
  const Vec3 x = across.x * base_.u + across.y * base_.n, z = along.x * base_.u + along.y * base_.n;
  const Point middle = lerp(left, right, 0.5);
  const double centre = 0.5 * (base_.low + base_.high);
  for (const Vec3& p : base_.ring) {
    const Vec3 from_middle = p - base_.middle;
    tube_.points.push_back(base_.at(middle.x, middle.y) +
                           scale * (dot(base_.u, from_middle) - centre) * x +
                           scale * dot(base_.v, from_middle) * base_.v +
                           scale * (1.0 - flatness) * dot(base_.n, from_middle) * z);
  }
  const auto n = static_cast<std::uint32_t>(base_.ring.size());
  const auto first = static_cast<std::uint32_t>(tube_.points.size()) - 2 * n;
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t a = first + i, b = first + (i + 1) % n;
    tube_.triangles.push_back({a, b, b + n});
    tube_.triangles.push_back({a, b + n, a + n});
  }
}

void Tube::close_tip(Point tip) {
  const auto n = static_cast<std::uint32_t>(base_.ring.size());
  const auto top = static_cast<std::uint32_t>(tube_.points.size());
  tube_.points.push_back(base_.at(tip.x, tip.y));
  for (std::uint32_t i = 0; i < n; ++i) {
    tube_.triangles.push_back({top - n + i, top - n + (i + 1) % n, top});
  }
}

Result<SolidBody> Tube::run(const Sides& sides, double depth_mm) {
  std::vector<Point> bottom;
  for (const Vec3& p : base_.ring) {
    tube_.points.push_back(p - depth_mm * base_.n);
    bottom.push_back({dot(base_.u, p), dot(base_.v, p)});
  }
  const Result<std::vector<SolidBody::Triangle>> cap = triangulate_ring(bottom);
  if (!cap) return invalid_data("the closed line bends around the body too far");
  for (const auto& [a, b, c] : *cap) tube_.triangles.push_back({b, a, c});
  const auto levels = static_cast<double>(sides.left.size());
  for (std::size_t i = 1; i < sides.left.size(); ++i) {
    if (distance(sides.left[i], sides.right[i]) < kTipShare * base_.width()) break;
    add_level(sides.left[i], sides.right[i], static_cast<double>(i) / levels);
  }
  close_tip(sides.tip);
  if (crosses_itself(tube_)) return invalid_data("the extruded part would cross itself");
  return std::move(tube_);
}

}  // namespace body_extrusion

Result<ExtrusionRing> ring_on_body(const SolidBody& body, std::span<const Vec3> path,
                                   const Vec3& view) {
  using namespace body_extrusion;
  const ViewFrame frame = view_frame(view);
  std::vector<Point> drawn;
  for (const Vec3& p : path) drawn.push_back(frame.to_picture(p));
  if (drawn.size() > 1 && distance(drawn.front(), drawn.back()) < 1e-9) drawn.pop_back();
  if (drawn.size() < 3) return invalid_data("the closed line has too few points");
  const double length = path_length(drawn) + distance(drawn.back(), drawn.front());
  if (!(length > 0.0)) return invalid_data("the closed line has no length");
  const int count = std::clamp(static_cast<int>(length / mean_edge_mm(body)), kMinRing, kMaxRing);
  std::vector<Point> ring = resampled_ring(drawn, count);
  if (self_crossing(ring, PathEnds::kClosed)) return invalid_data("the closed line crosses itself");
  if (ring_area(ring) < 0.0) std::reverse(ring.begin(), ring.end());
  ExtrusionRing base;
  for (const Point p : ring) {
    const auto hit = hit_from_eye(body, frame.to_solid(p, 0.0), -1.0 * frame.towards);
    if (!hit) return invalid_data("the closed line is not wholly on the body");
    base.points.push_back(hit->point);
    base.middle += (1.0 / count) * hit->point;
  }
  Vec3 area{};
  for (std::size_t i = 0; i < base.points.size(); ++i) {
    area += cross(base.points[i] - base.middle,
                  base.points[(i + 1) % base.points.size()] - base.middle);
  }
  if (!(norm(area) > 0.0)) return invalid_data("the closed line encloses nothing");
  base.normal = (1.0 / norm(area)) * area;
  return base;
}

Result<SolidBody> extrude_body(const SolidBody& body, std::span<const Vec3> path,
                               std::span<const Vec3> profile, const Vec3& view) {
  using namespace body_extrusion;
  Result<ExtrusionRing> ring = ring_on_body(body, path, view);
  if (!ring) return tl::unexpected(ring.error());
  Base base{std::move(ring->points), ring->middle, ring->normal};
  if (const Result<void> done = set_axes(base, profile); !done) return tl::unexpected(done.error());
  const Result<std::vector<Point>> flat = fitted_profile(base, profile);
  if (!flat) return tl::unexpected(flat.error());
  const Result<double> depth = depth_below(body, base);
  if (!depth) return tl::unexpected(depth.error());
  const Result<SolidBody> tube = Tube(base).run(sides_of(*flat, mean_edge_mm(body)), *depth);
  if (!tube) return tl::unexpected(tube.error());
  Result<SolidBody> joined = combine(body, *tube, BodyBoolean::kUnion);
  if (!joined) return tl::unexpected(joined.error());
  joined->stroke = body.stroke;
  joined->color = body.color;
  std::vector<SolidBody> parts = components_of(*joined);
  if (parts.size() != 1 || parts.front().holes != body.holes) {
    return invalid_data("the extruded part would touch the body elsewhere");
  }
  if (!check_body(parts.front(), {}) || volume_mm3(parts.front()) <= volume_mm3(body)) {
    return invalid_data("the extruded part runs along the surface of the body");
  }
  return std::move(parts.front());
}

}  // namespace felt
