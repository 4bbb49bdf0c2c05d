#include "felt/solid/solid_picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "felt/geometry/rect.h"
#include "felt/geometry/triangle_tree.h"
#include "felt/solid/creases.h"

namespace felt {
namespace solid_paint {

constexpr int kSamples = 3;  // per pixel and direction

/// Half the width of a painted edge, in pixels, and how much darker it is.
constexpr double kHalfLinePx = 0.5, kLineShade = 0.45;
/// Share of kCutColor in the colour of a cut.
constexpr double kCutShare = 0.6;

/// Returns the bounds of a solid as a camera sees it, in mm.
Rect seen_by(const SolidCamera& camera, const Solid& solid) {
  Rect seen;
  for (const SolidBody& body : solid.bodies) {
    for (const Vec3& p : body.points) seen.extend(Point{dot(camera.right, p), dot(camera.up, p)});
  }
  return seen;
}

/// Returns the bounds of what the camera sees if the solid turns about the vertical axis through x
/// = z = 0: those of the circles on which the points move.
Rect seen_in_turns(const SolidCamera& camera, const Solid& solid) {
  Rect seen;
  for (const SolidBody& body : solid.bodies) {
    for (const Vec3& p : body.points) {
      const double r = std::hypot(p.x, p.z), y = camera.up.y * p.y;
      const double depth = r * std::hypot(camera.up.x, camera.up.z);
      seen.extend(Point{-r, y - depth});
      seen.extend(Point{r, y + depth});
    }
  }
  return seen;
}

/// Returns the camera that fills the picture.
SolidCamera fitted_camera(const Solid& solid, const SolidView& view) {
  constexpr double kMargin = 0.06;
  SolidCamera camera = solid_camera(view.turn_deg, view.rise_deg);
  const Rect seen =
      view.fit == SolidFit::kTurn ? seen_in_turns(camera, solid) : seen_by(camera, solid);
  const double across = std::max(seen.width() / view.width_px, seen.height() / view.height_px);
  camera.px_per_mm = (1.0 - 2.0 * kMargin) / std::max(across, 1e-9);
  camera.origin_px = {0.5 * view.width_px - 0.5 * (seen.x0 + seen.x1) * camera.px_per_mm,
                      0.5 * view.height_px + 0.5 * (seen.y0 + seen.y1) * camera.px_per_mm};
  return camera;
}

SolidShade shade_of(Rgba color) {
  return {color.r / 255.0, color.g / 255.0, color.b / 255.0};
}

/// Returns the colour of a body under the ink at a point of its front: between the four nearest
/// pixels of the ink, because pixels would show as steps where the surface is steep.
SolidShade inked(const SolidShade& body, const FrontPaint& paint, const Vec3& at) {
  const Vec px = paint.to_px(at);
  const double left = std::floor(px.x - 0.5), top = std::floor(px.y - 0.5);
  SolidShade ink{};
  double alpha = 0.0;
  for (int k = 0; k < 4; ++k) {
    const double x = left + k % 2, y = top + k / 2;
    if (x < 0.0 || y < 0.0 || x >= paint.ink.width() || y >= paint.ink.height()) continue;
    const double share = (1.0 - std::fabs(px.x - 0.5 - x)) * (1.0 - std::fabs(px.y - 0.5 - y));
    const Rgba pixel = paint.ink.at(static_cast<int>(x), static_cast<int>(y));
    const SolidShade shade = shade_of(pixel);
    for (std::size_t part = 0; part < 3; ++part) ink[part] += share * shade[part];
    alpha += share * pixel.a / 255.0;
  }
  for (std::size_t part = 0; part < 3; ++part) ink[part] += (1.0 - alpha) * body[part];
  return ink;
}

/// Returns the colour in the light: half of it from a lamp, half from the sky and the floor, and a
/// weak reflection (Blinn, "Models of light reflection for computer synthesized pictures", 1977).
SolidShade lit(const SolidShade& color, const Vec3& normal, const SolidCamera& camera) {
  const Vec3 lamp = -0.45 * camera.right + 0.55 * camera.up + 0.70 * camera.towards;
  const Vec3 to_lamp = (1.0 / norm(lamp)) * lamp;
  const Vec3 half = to_lamp + camera.towards;
  const double direct = std::max(0.0, dot(normal, to_lamp));
  const double sky = 0.5 + 0.5 * dot(normal, camera.up);
  const double shine = std::pow(std::max(0.0, dot(normal, (1.0 / norm(half)) * half)), 40.0);
  SolidShade shade{};
  for (std::size_t k = 0; k < 3; ++k) {
    shade[k] = std::min(1.0, color[k] * (0.42 + 0.16 * sky + 0.50 * direct) + 0.12 * shine);
  }
  return shade;
}

/// The samples of a picture.
struct Samples {
  int width, height;
  std::vector<float> depth;
  std::vector<std::array<float, 3>> color;

  Samples(int w, int h, const SolidShade& paper)
      : width(w),
        height(h),
        depth(static_cast<std::size_t>(w) * static_cast<std::size_t>(h),
              -std::numeric_limits<float>::infinity()),
        color(depth.size(), stored(paper)) {}

  static std::array<float, 3> stored(const SolidShade& shade) {
    return {static_cast<float>(shade[0]), static_cast<float>(shade[1]),
            static_cast<float>(shade[2])};
  }
};

/// One corner of a triangle: its position in samples and depth, that on the body in mm, its normal
/// and its colour.
struct Corner {
  Vec3 at, on_body, normal;
  SolidShade color;
};

/// Paints triangles with a depth buffer.
class TrianglePainter {
 public:
  TrianglePainter(Samples& samples, const SolidCamera& camera, const SolidLook& look)
      : samples_(samples),
        camera_(camera),
        look_(look),
        section_mm_(look.section_x_mm.value_or(std::numeric_limits<double>::infinity())) {}

  void paint(const std::array<Corner, 3>& t);

 private:
  /// The position of a sample in a triangle: the shares of the corners.
  struct Shares {
    double u, v, w;
  };
  [[nodiscard]] SolidShade color_at(const std::array<Corner, 3>& t, const Shares& at,
                                    double area) const;
  [[nodiscard]] static Vec3 on_body(const std::array<Corner, 3>& t, const Shares& at) {
    return at.u * t[0].on_body + at.v * t[1].on_body + at.w * t[2].on_body;
  }
  [[nodiscard]] static bool is_on_edge(const std::array<Corner, 3>& t, const Shares& at,
                                       double area);

  Samples& samples_;
  const SolidCamera& camera_;
  const SolidLook& look_;
  double section_mm_;
};

bool TrianglePainter::is_on_edge(const std::array<Corner, 3>& t, const Shares& at, double area) {
  const std::array shares = {at.u, at.v, at.w};
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3 along = t[(k + 2) % 3].at - t[(k + 1) % 3].at;
    const double length = std::hypot(along.x, along.y);
    if (shares[k] * std::fabs(area) < kHalfLinePx * kSamples * length) return true;
  }
  return false;
}

/// Where something was cut away, the nearest surface that is seen from inside covers exactly the
/// cut, because bodies are closed. So it is painted as the cut.
SolidShade TrianglePainter::color_at(const std::array<Corner, 3>& t, const Shares& at,
                                     double area) const {
  SolidShade color{};
  for (std::size_t k = 0; k < 3; ++k) {
    color[k] = at.u * t[0].color[k] + at.v * t[1].color[k] + at.w * t[2].color[k];
  }
  if (area > 0.0) {
    SolidShade cut{};
    for (std::size_t k = 0; k < 3; ++k)
      cut[k] = kCutShare * kCutColor[k] + (1.0 - kCutShare) * color[k];
    return cut;
  }
  const Vec3 n = at.u * t[0].normal + at.v * t[1].normal + at.w * t[2].normal;
  const double length = norm(n);
  const Vec3 p = on_body(t, at);
  const bool has_ink = look_.paint != nullptr && p.z > 0.0 && n.z > kMinFrontNormal * length;
  const SolidShade coat = has_ink ? inked(color, *look_.paint, p) : color;
  SolidShade shade = lit(coat, length > 0.0 ? (1.0 / length) * n : camera_.towards, camera_);
  if (look_.wireframe == WireframeChoice::kShow && is_on_edge(t, at, area)) {
    for (double& part : shade) part *= kLineShade;
  }
  return shade;
}

/// Paints the samples inside a triangle that are in front of what is there.
void TrianglePainter::paint(const std::array<Corner, 3>& t) {
  const Vec3 &a = t[0].at, &b = t[1].at, &c = t[2].at;
  const double area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
  const bool is_inside = area > 0.0;  // y points down
  if (area == 0.0 || (is_inside && !look_.section_x_mm)) return;
  const auto clamped = [](double v, int high) {
    return static_cast<int>(std::clamp(v, 0.0, static_cast<double>(high)));
  };
  const int x0 = clamped(std::floor(std::min({a.x, b.x, c.x})), samples_.width - 1);
  const int x1 = clamped(std::ceil(std::max({a.x, b.x, c.x})), samples_.width - 1);
  const int y0 = clamped(std::floor(std::min({a.y, b.y, c.y})), samples_.height - 1);
  const int y1 = clamped(std::ceil(std::max({a.y, b.y, c.y})), samples_.height - 1);
  for (int y = y0; y <= y1; ++y) {
    for (int x = x0; x <= x1; ++x) {
      const double px = x + 0.5, py = y + 0.5;
      const double u = ((b.x - px) * (c.y - py) - (b.y - py) * (c.x - px)) / area;
      const double v = ((c.x - px) * (a.y - py) - (c.y - py) * (a.x - px)) / area;
      const double w = 1.0 - u - v;
      if (u < 0.0 || v < 0.0 || w < 0.0) continue;
      if (on_body(t, {u, v, w}).x > section_mm_) continue;
      const auto z = static_cast<float>(u * a.z + v * b.z + w * c.z);
      const auto i = static_cast<std::size_t>(y) * static_cast<std::size_t>(samples_.width) +
                     static_cast<std::size_t>(x);
      if (z <= samples_.depth[i]) continue;
      samples_.depth[i] = z;
      samples_.color[i] = Samples::stored(color_at(t, {u, v, w}, area));
    }
  }
}

/// Writes the mean of the samples of each pixel.
void write_pixels(const Samples& samples, Pixels out) {
  for (int y = 0; y < out.height; ++y) {
    for (int x = 0; x < out.width; ++x) {
      SolidShade sum{};
      for (int k = 0; k < kSamples * kSamples; ++k) {
        const auto row = static_cast<std::size_t>(y * kSamples + k / kSamples);
        const auto column = static_cast<std::size_t>(x * kSamples + k % kSamples);
        const std::array<float, 3>& color =
            samples.color[row * static_cast<std::size_t>(samples.width) + column];
        for (std::size_t part = 0; part < 3; ++part) sum[part] += static_cast<double>(color[part]);
      }
      std::uint8_t* pixel = out.data + y * out.stride + std::ptrdiff_t{4} * x;
      for (std::size_t part = 0; part < 3; ++part) {
        pixel[part] = static_cast<std::uint8_t>(255.0 * sum[part] / (kSamples * kSamples) + 0.5);
      }
      pixel[3] = 255;
    }
  }
}

Result<void> check_size(int width_px, int height_px) {
  const auto fits = [](int px) { return px >= 16 && px <= 8192; };
  if (fits(width_px) && fits(height_px)) return {};
  return fail(ErrorCode::kInvalidArgument, "a picture of a solid needs 16 to 8192 pixels");
}

}  // namespace solid_paint

SolidCamera solid_camera(double turn_deg, double rise_deg) noexcept {
  constexpr double kDegree = std::numbers::pi / 180.0;
  const double turn = turn_deg * kDegree, rise = rise_deg * kDegree;
  SolidCamera camera;
  camera.towards = {std::sin(turn) * std::cos(rise), std::sin(rise),
                    std::cos(turn) * std::cos(rise)};
  camera.right = {std::cos(turn), 0.0, -std::sin(turn)};
  camera.up = cross(camera.towards, camera.right);
  return camera;
}

Result<Image> paint_solid(const Solid& solid, const SolidView& view, const FrontPaint* paint) {
  if (solid.bodies.empty()) {
    return fail(ErrorCode::kInvalidArgument, "a picture of a solid needs a body");
  }
  if (Result<void> fits = solid_paint::check_size(view.width_px, view.height_px); !fits) {
    return tl::unexpected(fits.error());
  }
  SolidLook look;
  look.paint = paint;
  return paint_solid(solid, solid_paint::fitted_camera(solid, view), look, view.width_px,
                     view.height_px);
}

Result<Image> paint_solid(const Solid& solid, const SolidCamera& camera, const SolidLook& look,
                          int width_px, int height_px) {
  using namespace solid_paint;
  if (Result<void> fits = check_size(width_px, height_px); !fits) {
    return tl::unexpected(fits.error());
  }
  Result<Image> image = Image::create(width_px, height_px);
  if (!image) return image;
  const SolidShade paper = shade_of(look.paper);
  Samples samples(kSamples * width_px, kSamples * height_px, paper);
  TrianglePainter painter(samples, camera, look);
  for (const SolidBody& whole : solid.bodies) {
    const SolidBody body = split_at_creases(whole);
    const std::vector<Rgba> colors = point_colors(body);
    const std::vector<Vec3> normals = point_normals(body);
    for (const SolidBody::Triangle& t : body.triangles) {
      std::array<Corner, 3> corners;
      for (std::size_t k = 0; k < 3; ++k) {
        const Vec3& p = body.points[t[k]];
        const Vec3 px = camera.to_px(p);
        corners[k] = {
            {kSamples * px.x, kSamples * px.y, px.z}, p, normals[t[k]], shade_of(colors[t[k]])};
      }
      painter.paint(corners);
    }
  }
  write_pixels(samples, image->pixels());
  return image;
}

}  // namespace felt
