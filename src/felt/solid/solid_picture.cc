#include "felt/solid/solid_picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "felt/geometry/rect.h"

namespace felt {
namespace solid_paint {

constexpr int kSamples = 2;  // per pixel and direction

/// A linear or non-linear colour, 0..1 in each part.
using Shade = std::array<double, 3>;

Vec3 cross_of(const Vec3& a, const Vec3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// The axes of the camera in the frame of the solid: x right, y up, z towards the camera.
struct Camera {
  Vec3 x, y, z;
  double scale = 1.0;  // samples per mm
  double left = 0.0, top = 0.0;

  [[nodiscard]] Vec3 to(const Vec3& p) const {
    return {(dot(x, p) - left) * scale, (top - dot(y, p)) * scale, dot(z, p)};
  }
};

/// Returns the bounds of a solid as a camera sees it, in mm.
Rect seen_by(const Camera& camera, const Solid& solid) {
  Rect seen;
  for (const SolidBody& body : solid.bodies) {
    for (const Vec3& p : body.points) seen.extend(Point{dot(camera.x, p), dot(camera.y, p)});
  }
  return seen;
}

/// Returns the bounds of what the camera sees if the solid turns about the vertical axis through x
/// = z = 0: those of the circles on which the points move.
Rect seen_in_turns(const Camera& camera, const Solid& solid) {
  Rect seen;
  for (const SolidBody& body : solid.bodies) {
    for (const Vec3& p : body.points) {
      const double r = std::hypot(p.x, p.z), y = camera.y.y * p.y;
      const double depth = r * std::hypot(camera.y.x, camera.y.z);
      seen.extend(Point{-r, y - depth});
      seen.extend(Point{r, y + depth});
    }
  }
  return seen;
}

Camera camera_for(const Solid& solid, const SolidView& view) {
  constexpr double kDegree = std::numbers::pi / 180.0, kMargin = 0.06;
  const double turn = view.turn_deg * kDegree, rise = view.rise_deg * kDegree;
  Camera camera;
  camera.z = {std::sin(turn) * std::cos(rise), std::sin(rise), std::cos(turn) * std::cos(rise)};
  camera.x = {std::cos(turn), 0.0, -std::sin(turn)};
  camera.y = cross_of(camera.z, camera.x);
  const Rect seen =
      view.fit == SolidFit::kTurn ? seen_in_turns(camera, solid) : seen_by(camera, solid);
  const double across = std::max(seen.width() / view.width_px, seen.height() / view.height_px);
  camera.scale = kSamples * (1.0 - 2.0 * kMargin) / std::max(across, 1e-9);
  camera.left = 0.5 * (seen.x0 + seen.x1) - 0.5 * kSamples * view.width_px / camera.scale;
  camera.top = 0.5 * (seen.y0 + seen.y1) + 0.5 * kSamples * view.height_px / camera.scale;
  return camera;
}

Shade shade_of(Rgba color) {
  return {color.r / 255.0, color.g / 255.0, color.b / 255.0};
}

/// Returns the colour of a body under the ink at a point of its front.
Shade inked(const Shade& body, const FrontPaint& paint, const Vec3& at) {
  const Vec px = paint.to_px(at);
  const auto x = static_cast<int>(std::floor(px.x)), y = static_cast<int>(std::floor(px.y));
  if (x < 0 || y < 0 || x >= paint.ink.width() || y >= paint.ink.height()) return body;
  const Rgba ink = paint.ink.at(x, y);
  Shade shade = shade_of(ink);
  for (std::size_t k = 0; k < 3; ++k) shade[k] += (1.0 - ink.a / 255.0) * body[k];
  return shade;
}

/// Returns the colour in the light: half of it from a lamp, half from the sky and the floor, and a
/// weak reflection (Blinn, "Models of light reflection for computer synthesized pictures", 1977).
Shade lit(const Shade& color, const Vec3& normal, const Camera& camera) {
  const Vec3 lamp = -0.45 * camera.x + 0.55 * camera.y + 0.70 * camera.z;
  const Vec3 to_lamp = (1.0 / norm(lamp)) * lamp;
  const Vec3 half = to_lamp + camera.z;
  const double direct = std::max(0.0, dot(normal, to_lamp));
  const double sky = 0.5 + 0.5 * dot(normal, camera.y);
  const double shine = std::pow(std::max(0.0, dot(normal, (1.0 / norm(half)) * half)), 40.0);
  Shade shade{};
  for (std::size_t k = 0; k < 3; ++k) {
    shade[k] = std::min(1.0, color[k] * (0.42 + 0.16 * sky + 0.50 * direct) + 0.12 * shine);
  }
  return shade;
}

/// The samples of a picture.
struct Samples {
  int width, height;
  std::vector<double> depth;
  std::vector<Shade> color;

  Samples(int w, int h)
      : width(w),
        height(h),
        depth(static_cast<std::size_t>(w) * static_cast<std::size_t>(h),
              -std::numeric_limits<double>::infinity()),
        color(depth.size(), Shade{1.0, 1.0, 1.0}) {}
};

/// One corner of a triangle: its position in samples and depth, that on the body, and its normal.
struct Corner {
  Vec3 at, on_body, normal;
};

/// What a triangle is painted with.
struct Coat {
  Shade color;
  const FrontPaint* ink = nullptr;  // null if there is none
};

/// Paints the samples inside a triangle that are in front of what is there.
void paint_triangle(Samples& samples, const std::array<Corner, 3>& t, const Coat& coat,
                    const Camera& camera) {
  const Vec3 &a = t[0].at, &b = t[1].at, &c = t[2].at;
  const double area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
  if (area == 0.0) return;
  const auto clamped = [](double v, int high) {
    return static_cast<int>(std::clamp(v, 0.0, static_cast<double>(high)));
  };
  const int x0 = clamped(std::floor(std::min({a.x, b.x, c.x})), samples.width - 1);
  const int x1 = clamped(std::ceil(std::max({a.x, b.x, c.x})), samples.width - 1);
  const int y0 = clamped(std::floor(std::min({a.y, b.y, c.y})), samples.height - 1);
  const int y1 = clamped(std::ceil(std::max({a.y, b.y, c.y})), samples.height - 1);
  for (int y = y0; y <= y1; ++y) {
    for (int x = x0; x <= x1; ++x) {
      const double px = x + 0.5, py = y + 0.5;
      const double u = ((b.x - px) * (c.y - py) - (b.y - py) * (c.x - px)) / area;
      const double v = ((c.x - px) * (a.y - py) - (c.y - py) * (a.x - px)) / area;
      const double w = 1.0 - u - v;
      if (u < 0.0 || v < 0.0 || w < 0.0) continue;
      const double z = u * a.z + v * b.z + w * c.z;
      const auto i = static_cast<std::size_t>(y) * static_cast<std::size_t>(samples.width) +
                     static_cast<std::size_t>(x);
      if (z <= samples.depth[i]) continue;
      samples.depth[i] = z;
      const Vec3 n = u * t[0].normal + v * t[1].normal + w * t[2].normal;
      const double length = norm(n);
      const Shade color = coat.ink == nullptr
                              ? coat.color
                              : inked(coat.color, *coat.ink,
                                      u * t[0].on_body + v * t[1].on_body + w * t[2].on_body);
      samples.color[i] = lit(color, length > 0.0 ? (1.0 / length) * n : camera.z, camera);
    }
  }
}

/// Writes the mean of the samples of each pixel.
void write_pixels(const Samples& samples, Pixels out) {
  for (int y = 0; y < out.height; ++y) {
    for (int x = 0; x < out.width; ++x) {
      Shade sum{};
      for (int k = 0; k < kSamples * kSamples; ++k) {
        const auto row = static_cast<std::size_t>(y * kSamples + k / kSamples);
        const auto column = static_cast<std::size_t>(x * kSamples + k % kSamples);
        const Shade& color = samples.color[row * static_cast<std::size_t>(samples.width) + column];
        for (std::size_t part = 0; part < 3; ++part) sum[part] += color[part];
      }
      std::uint8_t* pixel = out.data + y * out.stride + std::ptrdiff_t{4} * x;
      for (std::size_t part = 0; part < 3; ++part) {
        pixel[part] = static_cast<std::uint8_t>(255.0 * sum[part] / (kSamples * kSamples) + 0.5);
      }
      pixel[3] = 255;
    }
  }
}

}  // namespace solid_paint

Result<Image> paint_solid(const Solid& solid, const SolidView& view, const FrontPaint* paint) {
  using namespace solid_paint;
  const auto fits = [](int px) { return px >= 16 && px <= 8192; };
  if (solid.bodies.empty() || !fits(view.width_px) || !fits(view.height_px)) {
    return fail(ErrorCode::kInvalidArgument, "a picture needs a body, and 16 to 8192 pixels");
  }
  Result<Image> image = Image::create(view.width_px, view.height_px);
  if (!image) return image;
  const Camera camera = camera_for(solid, view);
  Samples samples(kSamples * view.width_px, kSamples * view.height_px);
  for (const SolidBody& body : solid.bodies) {
    const Shade color = shade_of(shown_color(body.color));
    const std::vector<Vec3> normals = point_normals(body);
    for (const SolidBody::Triangle& t : body.triangles) {
      std::array<Corner, 3> corners;
      for (std::size_t k = 0; k < 3; ++k) {
        corners[k] = {camera.to(body.points[t[k]]), body.points[t[k]], normals[t[k]]};
      }
      paint_triangle(samples, corners, {color, is_front(body, t) ? paint : nullptr}, camera);
    }
  }
  write_pixels(samples, image->pixels());
  return image;
}

}  // namespace felt
