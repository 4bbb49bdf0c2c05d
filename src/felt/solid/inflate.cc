#include "felt/solid/inflate.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <optional>
#include <utility>

#include "felt/document/visible_strokes.h"
#include "felt/fill/curve_area.h"
#include "felt/geometry/rect.h"
#include "felt/solid/mirror_axes.h"
#include "felt/solid/plane_mesh.h"
#include "felt/solid/sector.h"
#include "felt/solid/unfold.h"

namespace felt {
namespace inflation {

/// The frame in which an area is meshed: its centre is (0, 0), y points up, and one of the mirror
/// axes is the x axis.
struct Frame {
  Point centre;  // in the body's frame
  Vec x_axis{1.0, 0.0};

  [[nodiscard]] Point to(Point p) const {
    return Point{} + Vec{dot(x_axis, p - centre), cross(x_axis, p - centre)};
  }
};

using Curves = std::vector<std::vector<Cubic>>;

/// Returns the curves in the body's frame: about the origin, y up.
Curves in_body_frame(const SolidOutline& outline, Point origin) {
  Curves curves = outline.loops;
  for (auto& curve : curves) {
    for (Cubic& c : curve) {
      for (Point& p : c.p) p = {p.x - origin.x, origin.y - p.y};
    }
  }
  return curves;
}

double area_inside(const Curves& curves) {
  double area = 0.0;
  for (std::size_t i = 0; i < curves.size(); ++i) {
    const double inside = std::fabs(loop_area(curves[i]));
    area += i == 0 ? inside : -inside;
  }
  return std::max(area, 0.0);
}

/// Mesh_2 with sides of at most e makes about area / 0.2 e^2 triangles inside, and about 1.2 more
/// for each edge of the border, because these are shorter (measured with discs, rings and stars).
constexpr double kTriangleArea = 0.2, kTrianglesPerBorderEdge = 1.2;
/// The edges of the border are shorter than the others, because the surface is steep there.
constexpr double kBorderShare = 0.5;
/// Each side of the coarse mesh has this share of the triangles. If a number was asked for, less is
/// left to the fine surface, because on an even body it divides all triangles or none.
constexpr double kCoarseShare = 0.25, kCoarseShareOfNumber = 0.4;

/// Returns the longest side of a triangle for about `count` triangles: the positive solution e of
/// count = area / 0.2 e^2 + 1.2 length / 0.5 e.
double edge_for(double count, double area_mm2, double length_mm) {
  const double linear = kTrianglesPerBorderEdge * length_mm / kBorderShare;
  const double constant = area_mm2 / kTriangleArea;
  return (linear + std::sqrt(linear * linear + 4.0 * count * constant)) / (2.0 * count);
}

/// Returns about how many triangles have sides of at most `edge_mm`: the inverse of edge_for().
double count_for(double edge_mm, double area_mm2, double length_mm) {
  return area_mm2 / (kTriangleArea * edge_mm * edge_mm) +
         kTrianglesPerBorderEdge * length_mm / (kBorderShare * edge_mm);
}

double length_of(const Curves& curves) {
  double length = 0.0;
  for (const auto& curve : curves) {
    for (const Cubic& c : curve) length += 0.5 * (control_length(c) + distance(c.p[0], c.p[3]));
  }
  return length;
}

/// Without a number of triangles, the coarse mesh is that of this number, and the figures below
/// decide what is added to it. With a number, they become larger or smaller by its ratio to this.
constexpr int kUsualTriangles = 5000;
/// The border is within 1/5 of a pixel of the outline if the body is this many pixels large.
constexpr double kOutlinePx = 1200.0, kOutlineShareOfPx = 0.18;
/// How far the normals of the surface turn along an edge.
constexpr double kTurnDeg = 8.0;

/// Returns the ratio of the usual number of triangles to that of the options.
double coarseness_of(const InflateOptions& options) {
  return double{kUsualTriangles} / options.triangles.value_or(kUsualTriangles);
}

/// Returns how far the normals of the surface may turn along an edge.
double max_turn_rad(const InflateOptions& options) {
  const double turn_deg = std::sqrt(coarseness_of(options)) * kTurnDeg;
  return std::clamp(turn_deg, 1.0, 45.0) * std::numbers::pi / 180.0;
}

/// Returns how fine the front of a body is that has this share of all triangles.
SurfaceSpec surface_spec_of(const RingSpec& ring, const InflateOptions& options, double share) {
  SurfaceSpec spec{.max_turn_rad = max_turn_rad(options), .min_edge_mm = 0.75 * ring.min_edge_mm};
  const int most = options.triangles.value_or(InflateOptions::kMaxTriangles);
  spec.max_triangles = static_cast<std::size_t>(0.5 * share * most);
  return spec;
}

/// Returns the lengths for a body, so that all bodies together have about the given number of
/// triangles, and each has enough for a shape.
RingSpec spec_of(const Curves& curves, const OutlineSize& whole, const InflateOptions& options) {
  constexpr double kMinFrontTriangles = 150.0;
  Rect box;
  for (const Cubic& c : curves.front()) box.extend(control_bounds(c));
  const double extent = std::max(box.width(), box.height());
  RingSpec spec;
  const double count = options.triangles ? kCoarseShareOfNumber * *options.triangles
                                         : kCoarseShare * kUsualTriangles;
  spec.edge_mm = std::min(edge_for(count, whole.area_mm2, whole.length_mm),
                          edge_for(kMinFrontTriangles, area_inside(curves), length_of(curves)));
  const double px_mm = extent / kOutlinePx * coarseness_of(options);
  spec.tolerance_mm = std::min({0.02 * spec.edge_mm, 0.05, kOutlineShareOfPx * px_mm});
  spec.min_edge_mm = 2.0 * px_mm;
  spec.max_turn_rad = max_turn_rad(options);
  spec.tip_mm = std::max(0.01 * spec.edge_mm, 1e-4 * extent);
  return spec;
}

/// Orients the outer ring from +x to +y and the holes against it.
void orient(std::vector<Ring>& rings) {
  for (std::size_t i = 0; i < rings.size(); ++i) {
    double twice = 0.0;
    for (std::size_t k = 0; k < rings[i].size(); ++k) {
      const Point a = rings[i][k], b = rings[i][(k + 1) % rings[i].size()];
      twice += cross(a - rings[i][0], b - rings[i][0]);
    }
    if ((twice > 0.0) != (i == 0)) std::reverse(rings[i].begin(), rings[i].end());
  }
}

/// Inflates one outline.
class Inflation {
 public:
  Inflation(const SolidOutline& outline, Point origin, const InflateOptions& options)
      : outline_(outline), origin_(origin), options_(options) {}

  Result<SolidBody> run(const OutlineSize& whole);

 private:
  [[nodiscard]] Result<SolidBody> body_from(const MirrorAxes& axes) const;
  Result<SolidBody> body_with(const MirrorAxes& axes);
  [[nodiscard]] tl::unexpected<Error> error_at(const char* what, Point p) const;
  [[nodiscard]] Result<SolidBody> checked(SolidBody body) const;

  const SolidOutline& outline_;
  Point origin_;
  InflateOptions options_;
  Curves curves_;
  RingSpec spec_;
  double share_ = 1.0;  // of all triangles, as of the area and the outlines
  std::vector<Ring> rings_;
};

tl::unexpected<Error> Inflation::error_at(const char* what, Point p) const {
  char text[160];
  std::snprintf(text, sizeof text, " %s at (%.2f, %.2f) mm", what, origin_.x + p.x,
                origin_.y - p.y);
  return fail(ErrorCode::kInvalidData,
              "the outline of stroke " + stroke_name(outline_.stroke) + text);
}

Result<SolidBody> Inflation::checked(SolidBody body) const {
  body.holes = static_cast<int>(outline_.loops.size()) - 1;
  body.stroke = outline_.stroke;
  body.color = outline_.color;
  if (Result<void> sound = check_body(body, origin_); !sound) {
    return tl::unexpected(with_context(sound.error(), "stroke " + stroke_name(outline_.stroke)));
  }
  return body;
}

Result<SolidBody> Inflation::body_from(const MirrorAxes& axes) const {
  Frame frame;
  if (axes.count > 0) frame = {axes.centre, unit_at(axes.angle_rad)};
  std::vector<Ring> rings = rings_;
  for (Ring& ring : rings) {
    for (Point& p : ring) p = frame.to(p);
  }
  RingSpec border = spec_;
  border.edge_mm *= kBorderShare;
  const std::optional<Sector> sector = cut_sector(rings, axes.count, border);
  if (!sector) return error_at("only touches its mirror axis", axes.centre);
  if (const std::optional<Point> p = crossing_of(*sector)) {
    const Vec v = *p - Point{};
    return error_at("touches or crosses itself",
                    frame.centre + v.x * frame.x_axis + v.y * perp(frame.x_axis));
  }
  // Narrow parts need triangles as small as they are narrow.
  const auto max_points =
      static_cast<std::size_t>(20 * options_.triangles.value_or(kUsualTriangles)) + 400'000;
  const Result<PlaneMesh> mesh =
      fill_plane(sector->points, sector->edges, spec_.edge_mm, max_points);
  if (!mesh) {
    return tl::unexpected(with_context(mesh.error(), "stroke " + stroke_name(outline_.stroke)));
  }
  return unfolded(*mesh, axes.count, surface_spec_of(spec_, options_, share_), options_.thickness,
                  frame.centre, frame.x_axis)
      .and_then([&](SolidBody body) { return checked(std::move(body)); });
}

Result<SolidBody> Inflation::run(const OutlineSize& whole) {
  curves_ = in_body_frame(outline_, origin_);
  spec_ = spec_of(curves_, whole, options_);
  const double all = count_for(spec_.edge_mm, whole.area_mm2, whole.length_mm);
  share_ = std::min(1.0, count_for(spec_.edge_mm, area_inside(curves_), length_of(curves_)) / all);
  for (const auto& curve : curves_) {
    rings_.push_back(fine_ring(curve, spec_));
    if (rings_.back().empty()) return error_at("is too narrow", curve.front().p[0]);
  }
  orient(rings_);
  const MirrorAxes axes = find_mirror_axes(curves_, rings_, 0.25 * spec_.tolerance_mm);
  if (axes.count > 0) {
    Result<SolidBody> body = body_with(axes);
    if (body) return body;
  }
  return body_with({});
}

/// Returns the body with small triangles at inner corners; if it is not sound, without them. At the
/// bottom of a narrow notch, the steep surface of such triangles may be too thin for a file.
Result<SolidBody> Inflation::body_with(const MirrorAxes& axes) {
  spec_.inner_corners = InnerCorners::kGraded;
  Result<SolidBody> body = body_from(axes);
  if (body) return body;
  spec_.inner_corners = InnerCorners::kPlain;
  return body_from(axes);
}

Result<void> check_options(const InflateOptions& options) {
  const int triangles = options.triangles.value_or(kUsualTriangles);
  const bool sound = triangles >= InflateOptions::kMinTriangles &&
                     triangles <= InflateOptions::kMaxTriangles && options.max_gap_mm >= 0.0 &&
                     options.max_gap_mm <= 32.0 && options.thickness >= 0.05 &&
                     options.thickness <= 20.0;
  if (sound) return {};
  return fail(ErrorCode::kInvalidArgument, "an option for solids is out of range");
}

}  // namespace inflation

OutlineSize size_of(const SolidOutline& outline) noexcept {
  return {inflation::area_inside(outline.loops), inflation::length_of(outline.loops)};
}

Result<SolidBody> inflate_outline(const SolidOutline& outline, Point origin,
                                  const OutlineSize& whole, const InflateOptions& options) {
  if (Result<void> sound = inflation::check_options(options); !sound) {
    return tl::unexpected(sound.error());
  }
  return inflation::Inflation(outline, origin, options).run(whole);
}

Result<InflatedDrawing> inflate(const Document& document, const InflateOptions& options) {
  if (Result<void> sound = inflation::check_options(options); !sound) {
    return tl::unexpected(sound.error());
  }
  Result<FoundOutlines> found =
      find_outlines(document, options.max_gap_mm, options.holes, options.faults);
  if (!found) return tl::unexpected(found.error());
  Rect box;
  OutlineSize whole;
  for (const SolidOutline& outline : found->outlines) {
    for (const Cubic& c : outline.loops.front()) box.extend(bounds(c));
    const OutlineSize size = size_of(outline);
    whole.area_mm2 += size.area_mm2;
    whole.length_mm += size.length_mm;
  }
  InflatedDrawing result;
  result.notes = std::move(found->notes);
  result.solid.origin = {0.5 * (box.x0 + box.x1), 0.5 * (box.y0 + box.y1)};
  Error last_fault;
  for (const SolidOutline& outline : found->outlines) {
    Result<SolidBody> body = inflation::Inflation(outline, result.solid.origin, options).run(whole);
    if (!body && options.faults == FaultChoice::kRefuse) return tl::unexpected(body.error());
    if (body) {
      result.solid.bodies.push_back(*std::move(body));
    } else {
      result.notes.push_back("left out: " + body.error().message);
      last_fault = body.error();
    }
  }
  if (result.solid.bodies.empty()) return tl::unexpected(last_fault);
  return result;
}

}  // namespace felt
