#include "felt/solid/unfold.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "felt/geometry/rect.h"
#include "felt/solid/chords.h"
#include "felt/solid/sector.h"

namespace felt {
namespace unfolding {

/// One sector with the heights of its points.
struct Half {
  PlaneMesh mesh;
  std::vector<std::uint8_t> on_border;
  std::vector<RayFlags> rays;
  std::vector<double> heights;
};

double axis_tolerance(const PlaneMesh& mesh) {
  Rect box;
  for (const Point p : mesh.points) box.extend(p);
  return 1e-9 * std::max(box.width(), box.height());
}

/// Finds the points on axes and makes their positions exact.
std::vector<RayFlags> put_on_axes(PlaneMesh& mesh, int axes, double tolerance_mm) {
  std::vector<RayFlags> rays;
  const Vec last = unit_at(axes > 0 ? std::numbers::pi / axes : 0.0);
  for (Point& p : mesh.points) {
    const RayFlags on = rays_of(p, axes, tolerance_mm);
    if (on.first && on.last)
      p = {0.0, 0.0};
    else if (on.first)
      p.y = 0.0;
    else if (on.last)
      p = Point{} + dot(last, p - Point{}) * last;
    rays.push_back(on);
  }
  return rays;
}

bool share_a_ray(const RayFlags& a, const RayFlags& b) {
  return (a.first && b.first) || (a.last && b.last);
}

Result<Half> half_of(PlaneMesh mesh, int axes, const SurfaceSpec& spec) {
  Half half;
  const double tolerance_mm = axis_tolerance(mesh);
  half.rays = put_on_axes(mesh, axes, tolerance_mm);
  // With one axis, the two rays are one line, and an edge may cross the centre.
  const auto on_line = [&](std::uint32_t i) { return half.rays[i].first || half.rays[i].last; };
  std::vector<std::uint8_t> is_axis;
  half.on_border.assign(mesh.points.size(), 0);
  for (const auto& [a, b] : mesh.edges) {
    const bool axis =
        share_a_ray(half.rays[a], half.rays[b]) || (axes == 1 && on_line(a) && on_line(b));
    is_axis.push_back(axis ? 1 : 0);
    if (!axis) half.on_border[a] = half.on_border[b] = 1;
  }
  half.mesh = without_chords(std::move(mesh), is_axis, half.on_border);
  const Result<SquaredHeights> squares = squared_heights(half.mesh, half.on_border);
  if (!squares) return tl::unexpected(squares.error());
  SurfaceSpec of_sector = spec;
  of_sector.max_triangles /= static_cast<std::size_t>(std::max(1, 2 * axes));
  FineSurface fine = fine_surface(half.mesh, half.on_border, *squares, of_sector);
  half.mesh = std::move(fine.mesh);
  half.on_border = std::move(fine.on_border);
  half.heights = std::move(fine.heights);
  half.rays = put_on_axes(half.mesh, axes, tolerance_mm);
  return half;
}

/// Joins the copies of a sector. Copy 2r is the sector turned by 2r sectors; copy 2r + 1 is its
/// mirror image in the last ray of copy 2r.
class Unfolder {
 public:
  Unfolder(const Half& half, int axes) : half_(half), axes_(axes), copies_(std::max(1, 2 * axes)) {}

  /// Returns the whole area as a mesh in its own frame, with heights and marks of the border.
  Half unfold();

 private:
  [[nodiscard]] int owner(int copy, std::size_t i) const;
  [[nodiscard]] Point placed(int copy, Point p) const;

  const Half& half_;
  int axes_;
  int copies_;
};

/// Returns the copy that has the point first.
int Unfolder::owner(int copy, std::size_t i) const {
  const RayFlags on = half_.rays[i];
  if (on.first && on.last) return 0;
  if (on.last) return copy - copy % 2;
  if (on.first && copy % 2 == 1) return (copy + 1) % copies_;
  return copy;
}

Point Unfolder::placed(int copy, Point p) const {
  if (copy == 0) return p;
  const double sector = std::numbers::pi / axes_;
  if (copy % 2 == 0) {
    const Vec turn = unit_at(copy * sector);
    return {turn.x * p.x - turn.y * p.y, turn.y * p.x + turn.x * p.y};
  }
  const Vec twice = unit_at((copy + 1) * sector);  // mirrors at half of this angle
  return {twice.x * p.x + twice.y * p.y, twice.y * p.x - twice.x * p.y};
}

Half Unfolder::unfold() {
  Half whole;
  const std::size_t n = half_.mesh.points.size();
  std::vector<std::uint32_t> number(n * static_cast<std::size_t>(copies_));
  const auto slot = [&](int copy, std::size_t i) { return static_cast<std::size_t>(copy) * n + i; };
  for (int copy = 0; copy < copies_; ++copy) {
    for (std::size_t i = 0; i < n; ++i) {
      if (owner(copy, i) != copy) continue;
      number[slot(copy, i)] = static_cast<std::uint32_t>(whole.mesh.points.size());
      whole.mesh.points.push_back(placed(copy, half_.mesh.points[i]));
      whole.heights.push_back(half_.heights[i]);
      whole.on_border.push_back(half_.on_border[i]);
    }
  }
  for (int copy = 0; copy < copies_; ++copy) {
    for (const auto& t : half_.mesh.triangles) {
      std::array<std::uint32_t, 3> corners{};
      for (std::size_t k = 0; k < 3; ++k) corners[k] = number[slot(owner(copy, t[k]), t[k])];
      if (copy % 2 == 1) std::swap(corners[1], corners[2]);
      whole.mesh.triangles.push_back(corners);
    }
  }
  return whole;
}

/// Adds the back, and numbers the points of the border first.
SolidBody both_sides(const Half& whole, double thickness) {
  SolidBody body;
  const std::size_t n = whole.mesh.points.size();
  std::vector<std::uint32_t> front(n), back(n);
  const auto add = [&](std::size_t i, double z) {
    body.points.push_back({whole.mesh.points[i].x, whole.mesh.points[i].y, z});
    return static_cast<std::uint32_t>(body.points.size() - 1);
  };
  for (std::size_t i = 0; i < n; ++i) {
    if (whole.on_border[i]) front[i] = back[i] = add(i, 0.0);
  }
  body.border_count = body.points.size();
  for (std::size_t i = 0; i < n; ++i) {
    if (!whole.on_border[i]) front[i] = add(i, thickness * whole.heights[i]);
  }
  for (std::size_t i = 0; i < n; ++i) {
    if (!whole.on_border[i]) back[i] = add(i, -thickness * whole.heights[i]);
  }
  for (const auto& [a, b, c] : whole.mesh.triangles) {
    body.triangles.push_back({front[a], front[b], front[c]});
    body.triangles.push_back({back[a], back[c], back[b]});
  }
  return body;
}

}  // namespace unfolding

Vec unit_at(double angle_rad) noexcept {
  constexpr double kRounding = 1e-15;
  Vec unit{std::cos(angle_rad), std::sin(angle_rad)};
  if (std::fabs(unit.x) < kRounding) unit = {0.0, unit.y > 0.0 ? 1.0 : -1.0};
  if (std::fabs(unit.y) < kRounding) unit = {unit.x > 0.0 ? 1.0 : -1.0, 0.0};
  return unit;
}

Result<SolidBody> unfolded(PlaneMesh mesh, int axes, const SurfaceSpec& spec, double thickness,
                           Point centre, Vec x_axis) {
  const Result<unfolding::Half> half = unfolding::half_of(std::move(mesh), axes, spec);
  if (!half) return tl::unexpected(half.error());
  SolidBody body = unfolding::both_sides(unfolding::Unfolder(*half, axes).unfold(), thickness);
  const Vec y_axis = perp(x_axis);
  for (Vec3& p : body.points) {
    const Point at = centre + p.x * x_axis + p.y * y_axis;
    p = {at.x, at.y, p.z};
  }
  return body;
}

}  // namespace felt
