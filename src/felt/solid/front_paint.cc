#include "felt/solid/front_paint.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "felt/base/check.h"
#include "felt/document/edit_builder.h"
#include "felt/geometry/bvh.h"
#include "felt/geometry/rect.h"
#include "felt/geometry/triangle_tree.h"
#include "felt/render/page_painter.h"

namespace felt {
namespace front_painting {

constexpr double kOnOutlineMm = 0.5;  // a rough sketch of an outline is that far beside it
constexpr double kStepMm = 0.5;       // between two samples of a stroke
constexpr int kMaxSamples = 2000;     // of a segment

/// The outlines of all bodies on the page.
SegmentBvh outlines_of(const Solid& solid) {
  const auto on_page = [&solid](const Vec3& p) {
    return Point{solid.origin.x + p.x, solid.origin.y - p.y};
  };
  std::vector<BvhSegment> edges;
  for (const SolidBody& body : solid.bodies) {
    for (const SolidBody::Triangle& t : body.triangles) {
      if (!is_front(body, t)) continue;
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t a = t[k], b = t[(k + 1) % 3];
        if (a >= body.border_count || b >= body.border_count) continue;
        edges.push_back({straight(on_page(body.points[a]), on_page(body.points[b])), {}});
      }
    }
  }
  SegmentBvh tree;
  tree.build(edges);
  return tree;
}

bool follows(const Stroke& stroke, const SegmentBvh& outlines) {
  int samples = 0, on_outline = 0;
  for (int i = 0; i < stroke.segment_count(); ++i) {
    const Cubic curve = stroke.segment(i);
    const double steps = std::clamp(std::ceil(control_length(curve) / kStepMm), 1.0,
                                    static_cast<double>(kMaxSamples));
    for (int k = 0; k < static_cast<int>(steps); ++k) {
      const Point at = evaluate(curve, (k + 0.5) / steps);
      ++samples;
      on_outline += outlines.nearest({.point = at, .radius_mm = kOnOutlineMm}) ? 1 : 0;
    }
  }
  return 2 * on_outline > samples;
}

/// Returns the document without the strokes that have become the bodies.
Document without_outlines(const Document& document, const Solid& solid) {
  const SegmentBvh outlines = outlines_of(solid);
  EditBuilder edit(document);
  for (const Layer& layer : document.layers()) {
    for (const StrokeId id : layer.strokes) {
      const StrokePtr stroke = document.find(id);
      if (stroke && follows(*stroke, outlines)) edit.remove(id);
    }
  }
  Document rest = document;
  FELT_CHECK(rest.apply(std::move(edit).build("Paint")).has_value());
  return rest;
}

/// The bounds of the points in x and y, seen from the front; empty without points.
Rect bounds_of(const SolidBody& body) {
  Rect area;
  for (const Vec3& p : body.points) area.extend(Point{p.x, p.y});
  return area;
}

bool is_blank(const Image& image, const PixelRect& part) {
  for (int y = part.y0; y < part.y1; ++y) {
    for (int x = part.x0; x < part.x1; ++x) {
      if (image.at(x, y).a != 0) return false;
    }
  }
  return true;
}

/// The corners of a triangle on the picture.
using PixelTriangle = std::array<Vec, 3>;

/// Returns true if there is ink at the centre of a pixel in the triangle or on its border.
bool has_ink(const Image& ink, const PixelTriangle& corners) {
  const auto [a, b, c] = corners;
  const double turn = cross(b - a, c - a) < 0.0 ? -1.0 : 1.0;
  const auto is_left = [turn](const Vec& from, const Vec& to, const Vec& p) {
    return turn * cross(to - from, p - from) >= 0.0;
  };
  const auto first = [](double least, int end) {
    return static_cast<int>(std::clamp(std::floor(least), 0.0, static_cast<double>(end)));
  };
  const auto end = [](double most, int end_of_image) {
    return static_cast<int>(std::clamp(std::ceil(most), 0.0, static_cast<double>(end_of_image)));
  };
  const int x0 = first(std::min({a.x, b.x, c.x}), ink.width());
  const int x1 = end(std::max({a.x, b.x, c.x}), ink.width());
  const int y1 = end(std::max({a.y, b.y, c.y}), ink.height());
  for (int y = first(std::min({a.y, b.y, c.y}), ink.height()); y < y1; ++y) {
    for (int x = x0; x < x1; ++x) {
      const Vec p{x + 0.5, y + 0.5};
      if (ink.at(x, y).a != 0 && is_left(a, b, p) && is_left(b, c, p) && is_left(c, a, p)) {
        return true;
      }
    }
  }
  return false;
}

/// Returns true if there is ink on the front of a body. Ink beside the bodies and in their holes
/// does not count.
bool has_ink_on(const Solid& solid, const FrontPaint& paint) {
  for (const SolidBody& body : solid.bodies) {
    for (const SolidBody::Triangle& t : body.triangles) {
      if (!is_front(body, t)) continue;
      const auto corner = [&](std::size_t k) { return paint.to_px(body.points[t[k]]); };
      if (has_ink(paint.ink, {corner(0), corner(1), corner(2)})) return true;
    }
  }
  return false;
}

}  // namespace front_painting

bool is_front(const SolidBody& body, const SolidBody::Triangle& triangle) noexcept {
  double z = 0.0;
  for (const std::uint32_t corner : triangle) z += body.points[corner].z;
  if (z <= 0.0) return false;
  const Vec3& a = body.points[triangle[0]];
  const Vec3 n = cross(body.points[triangle[1]] - a, body.points[triangle[2]] - a);
  return n.z > kMinFrontNormal * norm(n);
}

std::vector<Rgba> point_colors(const SolidBody& body) {
  const Rgba under = shown_color(body.color);
  std::vector<Rgba> colors(body.points.size(), under);
  for (std::size_t i = 0; i < body.paint.size(); ++i) {
    const Rgba over = body.paint[i];
    const auto part = [&over](std::uint8_t u, std::uint8_t o) {
      return static_cast<std::uint8_t>((o * over.a + u * (255 - over.a) + 127) / 255);
    };
    colors[i] = {part(under.r, over.r), part(under.g, over.g), part(under.b, over.b), 255};
  }
  return colors;
}

Rgba shown_color(Rgba color) noexcept {
  constexpr double kMinLight = 0.8;
  const double light = (0.2126 * color.r + 0.7152 * color.g + 0.0722 * color.b) / 255.0;
  const double mix = light >= kMinLight ? 0.0 : (kMinLight - light) / (1.0 - light);  // with white
  const auto shown = [mix](std::uint8_t part) {
    return static_cast<std::uint8_t>(std::lround(part + mix * (255.0 - part)));
  };
  return {shown(color.r), shown(color.g), shown(color.b), 255};
}

Result<std::optional<FrontPaint>> front_paint(const Document& document, const Solid& solid,
                                              const Grain& grain) {
  using namespace front_painting;
  Rect area;
  for (const SolidBody& body : solid.bodies) area.extend(bounds_of(body));
  if (area.empty()) return std::optional<FrontPaint>();
  const double longest_mm = std::max({area.width(), area.height(), 1e-6});
  const double px_per_mm = std::min(FrontPaint::kMaxPxPerMm, FrontPaint::kMaxPx / longest_mm);
  PageOptions options{.dpi = px_per_mm * kMmPerInch, .paper = {0, 0, 0, 0}, .grain = grain};
  options.area = Rect{solid.origin.x + area.x0, solid.origin.y - area.y1, solid.origin.x + area.x1,
                      solid.origin.y - area.y0};
  Result<Image> ink =
      render_page(without_outlines(document, solid), options, PictureChoice::kMarked);
  if (!ink) return tl::unexpected(ink.error());
  FrontPaint paint{*std::move(ink), {area.x0, area.y1}, px_per_mm};
  if (!has_ink_on(solid, paint)) return std::optional<FrontPaint>();
  return paint;
}

Result<std::optional<FrontPaint>> painted_front(const SolidBody& body, const FrontPaint& paint) {
  const Rect area = front_painting::bounds_of(body);
  const Vec corner = paint.to_px({area.x0, area.y1, 0.0});
  const int left = std::clamp(static_cast<int>(std::floor(corner.x)), 0, paint.ink.width() - 1);
  const int top = std::clamp(static_cast<int>(std::floor(corner.y)), 0, paint.ink.height() - 1);
  const Vec far = paint.to_px({area.x1, area.y0, 0.0});
  const auto side = [](double to, int from, int end) {
    return std::clamp(static_cast<int>(std::ceil(to)) - from, 1, end - from);
  };
  const PixelRect part{left, top, left + side(far.x, left, paint.ink.width()),
                       top + side(far.y, top, paint.ink.height())};
  if (front_painting::is_blank(paint.ink, part)) return std::optional<FrontPaint>();
  Result<Image> image = Image::create(part.width(), part.height());
  if (!image) return tl::unexpected(image.error());
  const Pixels out = image->pixels();
  const Rgba under = shown_color(body.color);
  for (int y = 0; y < out.height; ++y) {
    for (int x = 0; x < out.width; ++x) {
      const Rgba over = paint.ink.at(left + x, top + y);
      std::uint8_t* pixel = out.data + y * out.stride + std::ptrdiff_t{4} * x;
      const auto mixed = [&over](std::uint8_t ink, std::uint8_t body_part) {
        return static_cast<std::uint8_t>(ink + (body_part * (255 - over.a) + 127) / 255);
      };
      pixel[0] = mixed(over.r, under.r);
      pixel[1] = mixed(over.g, under.g);
      pixel[2] = mixed(over.b, under.b);
      pixel[3] = 255;
    }
  }
  const Vec at = paint.corner_mm + Vec{left / paint.px_per_mm, -top / paint.px_per_mm};
  return FrontPaint{*std::move(image), at, paint.px_per_mm};
}

}  // namespace felt
