#include "tests/formats/svg/scene_picture.h"

#include <agg2/agg_conv_stroke.h>
#include <agg2/agg_conv_transform.h>
#include <agg2/agg_path_storage.h>
#include <agg2/agg_pixfmt_rgba.h>
#include <agg2/agg_rasterizer_scanline_aa.h>
#include <agg2/agg_renderer_base.h>
#include <agg2/agg_renderer_scanline.h>
#include <agg2/agg_rendering_buffer.h>
#include <agg2/agg_scanline_u.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

#include "felt/io/svg/svg_dashes.h"

namespace felt::testing {
namespace {

class Collector final : public SvgSceneSink {
 public:
  explicit Collector(PaintedScene& scene) : scene_(scene) {}
  void root(const SvgRoot& root) override { scene_.root = root; }
  void layer(const SvgLayer& layer) override {
    visible_ = layer.visible && (!layer.group || layer.group->visible);
  }
  void shape(SvgShape shape) override {
    if (visible_) scene_.shapes.push_back(std::move(shape));
  }
  void image(const SvgImage& image) override {
    notice(image.line_number, "image", "is not drawn by this test");
  }
  void paper(Rgba color) override { scene_.paper = color; }
  void end() override {}
  void notice(std::int64_t line, std::string element, std::string what) override {
    scene_.notices.push_back("line " + std::to_string(line) + ": " + element + " " + what);
  }

 private:
  PaintedScene& scene_;
  bool visible_ = true;
};

using Cells = agg::rasterizer_scanline_aa<agg::rasterizer_sl_clip_dbl>;
using Format = agg::pixfmt_rgba32_pre;

constexpr int kPieces = 48;  ///< number of straight pieces per cubic

void append(agg::path_storage& path, const SvgContour& contour) {
  path.move_to(contour.points[0].x, contour.points[0].y);
  for (std::size_t i = 0; i < contour.segment_count(); ++i) {
    const Cubic c = contour.segment(i);
    const int pieces = flatness(c) < 1e-9 * control_length(c) ? 1 : kPieces;
    for (int k = 1; k <= pieces; ++k) {
      const Point p = evaluate(c, static_cast<double>(k) / pieces);
      path.line_to(p.x, p.y);
    }
  }
  if (contour.closed) path.close_polygon();
}

bool is_dot(const SvgContour& c) {
  return std::all_of(c.points.begin(), c.points.end(), [&](Point p) { return p == c.points[0]; });
}

class Painter {
 public:
  Painter(Image& image, double px_per_mm)
      : target_(image.pixels()),
        buffer_(image.pixels().data, static_cast<unsigned>(image.width()),
                static_cast<unsigned>(image.height()), static_cast<int>(image.pixels().stride)),
        format_(buffer_),
        base_(format_),
        width_(image.width()),
        height_(image.height()),
        scale_(px_per_mm) {}

  void paint(const SvgShape& shape) {
    if (shape.fill) fill(shape);
    if (shape.line) line(shape);
  }

 private:
  [[nodiscard]] agg::trans_affine to_px(const SvgShape& s) const {
    const Affine& m = s.to_mm;
    agg::trans_affine map(m.a, m.b, m.c, m.d, m.e, m.f);
    map *= agg::trans_affine_scaling(scale_);
    return map;
  }

  void begin(const SvgShape& shape, bool even_odd) {
    cells_.reset();
    Rect clip{0.0, 0.0, static_cast<double>(width_), static_cast<double>(height_)};
    slanted_ = false;
    frame_ = {{clip.x0, clip.y0}, {clip.x1, clip.y0}, {clip.x1, clip.y1}, {clip.x0, clip.y1}};
    if (shape.frame) {
      for (const SvgHalfPlane& plane : shape.frame->planes()) cut_frame(plane);
    }
    if (!slanted_ && shape.frame) {
      Rect inside;
      for (const Point p : frame_) inside.extend(p);
      clip = inside;
    }
    nothing_ = clip.empty() || frame_.empty();
    cells_.clip_box(clip.x0, clip.y0, clip.x1, clip.y1);
    cells_.filling_rule(even_odd ? agg::fill_even_odd : agg::fill_non_zero);
  }

  void finish(Rgba color) {
    if (nothing_) return;
    agg::rgba8 ink(color.r, color.g, color.b, color.a);
    if (slanted_) return finish_in_frame(ink);
    agg::render_scanlines_aa_solid(cells_, scanline_, base_, ink.premultiply());
  }

  /// Keeps the part of the frame on one side of a line.
  void cut_frame(const SvgHalfPlane& plane) {
    if (plane.normal.x != 0.0 && plane.normal.y != 0.0) slanted_ = true;
    const auto outside = [&](Point p) { return plane.outside_mm({p.x / scale_, p.y / scale_}); };
    std::vector<Point> kept;
    for (std::size_t i = 0; i < frame_.size(); ++i) {
      const Point a = frame_[i], b = frame_[(i + 1) % frame_.size()];
      const double at_a = outside(a), at_b = outside(b);
      if (at_a <= 0.0) kept.push_back(a);
      if ((at_a <= 0.0) != (at_b <= 0.0)) kept.push_back(lerp(a, b, at_a / (at_a - at_b)));
    }
    frame_ = std::move(kept);
  }

  /// Paints the cells inside a rotated frame: their alpha times that of the frame.
  void finish_in_frame(agg::rgba8 ink) {
    Image shape = Image::create(width_, height_).value(), mask = shape;
    Painter on_shape(shape, scale_), on_mask(mask, scale_);
    agg::render_scanlines_aa_solid(cells_, scanline_, on_shape.base_, ink.premultiply());
    agg::path_storage path;
    for (std::size_t i = 0; i < frame_.size(); ++i) {
      i == 0 ? path.move_to(frame_[i].x, frame_[i].y) : path.line_to(frame_[i].x, frame_[i].y);
    }
    path.close_polygon();
    cells_.reset();
    cells_.add_path(path);
    agg::render_scanlines_aa_solid(cells_, scanline_, on_mask.base_,
                                   agg::rgba8(255, 255, 255, 255));
    std::uint8_t* to = shape.pixels().data;
    for (std::size_t i = 0; i < mask.bytes().size(); ++i) {
      to[i] = static_cast<std::uint8_t>(to[i] * mask.bytes()[i / 4 * 4 + 3] / 255);
    }
    blend(shape.pixels(), shape.pixels().rect(), 1.0, BlendMode::kNormal, {255, 255, 255, 255},
          target_);
  }

  void fill(const SvgShape& shape) {
    begin(shape, shape.fill->even_odd);
    agg::path_storage path;
    for (const SvgContour& c : shape.contours) append(path, c);
    agg::trans_affine map = to_px(shape);
    agg::conv_transform<agg::path_storage> moved(path, map);
    cells_.add_path(moved);
    finish(shape.fill->color);
  }

  void line(const SvgShape& shape) {
    const SvgLine& l = *shape.line;
    begin(shape, false);
    agg::trans_affine map = to_px(shape);
    for (const SvgContour& c : shape.contours) {
      std::vector<SvgContour> parts{c};
      if (!l.dashes.empty()) {
        parts = svg_dashes(c, l.dashes, l.dash_offset, l.cap != SvgCap::kButt, 100000)
                    .value_or(std::vector<SvgContour>{c});
      }
      for (const SvgContour& part : parts) stroke(part, l, map);
    }
    finish(l.color);
  }

  void stroke(const SvgContour& contour, const SvgLine& l, agg::trans_affine& map) {
    agg::path_storage path;
    if (is_dot(contour)) {
      dot(path, contour.points[0], l);
      agg::conv_transform<agg::path_storage> moved(path, map);
      return cells_.add_path(moved);
    }
    append(path, contour);
    agg::conv_stroke<agg::path_storage> wide(path);
    wide.width(l.width);
    wide.line_cap(l.cap == SvgCap::kButt    ? agg::butt_cap
                  : l.cap == SvgCap::kRound ? agg::round_cap
                                            : agg::square_cap);
    wide.line_join(l.join == SvgJoin::kMiter   ? agg::miter_join_revert
                   : l.join == SvgJoin::kRound ? agg::round_join
                                               : agg::bevel_join);
    wide.inner_join(agg::inner_round);
    wide.miter_limit(l.miter_limit);
    wide.approximation_scale(4.0 * map.scale());
    agg::conv_transform<agg::conv_stroke<agg::path_storage>> moved(wide, map);
    cells_.add_path(moved);
  }

  static void dot(agg::path_storage& path, Point p, const SvgLine& l) {
    if (l.cap == SvgCap::kButt) return;
    const int corners = l.cap == SvgCap::kSquare ? 4 : 64;
    const double r = 0.5 * l.width * (corners == 4 ? std::sqrt(2.0) : 1.0);
    for (int k = 0; k < corners; ++k) {
      const double angle = (2.0 * k + 1.0) * 3.141592653589793 / corners;
      const double x = p.x + r * std::cos(angle), y = p.y + r * std::sin(angle);
      k == 0 ? path.move_to(x, y) : path.line_to(x, y);
    }
    path.close_polygon();
  }

  Pixels target_;
  agg::rendering_buffer buffer_;
  Format format_;
  agg::renderer_base<Format> base_;
  int width_, height_;
  double scale_;
  Cells cells_;
  agg::scanline_u8 scanline_;
  bool nothing_ = false;
  std::vector<Point> frame_;  ///< the visible part of the picture, in pixels
  bool slanted_ = false;
};

/// Returns true if the pixel (x, y) of `a` is within `tolerance` of the same pixel of `b`, or of
/// the range of the nine pixels around it in `b`.
bool has_like(const Image& a, const Image& b, int x, int y, int tolerance) {
  const auto at = [](const Image& image, int u, int v) {
    return image.bytes().data() + 4 * (static_cast<std::ptrdiff_t>(v) * image.width() + u);
  };
  const std::uint8_t* pixel = at(a, x, y);
  const std::uint8_t* same = at(b, x, y);
  bool close = true;
  for (int c = 0; c < 4; ++c) close = close && std::abs(pixel[c] - same[c]) <= tolerance;
  if (close) return true;
  std::array<int, 4> smallest{255, 255, 255, 255}, largest{};
  for (int v = std::max(0, y - 1); v <= std::min(b.height() - 1, y + 1); ++v) {
    for (int u = std::max(0, x - 1); u <= std::min(b.width() - 1, x + 1); ++u) {
      for (std::size_t c = 0; c < 4; ++c) {
        smallest[c] = std::min<int>(smallest[c], at(b, u, v)[c]);
        largest[c] = std::max<int>(largest[c], at(b, u, v)[c]);
      }
    }
  }
  for (std::size_t c = 0; c < 4; ++c) {
    if (pixel[c] < smallest[c] - tolerance || pixel[c] > largest[c] + tolerance) return false;
  }
  return true;
}

std::int64_t pixels_without_like(const Image& a, const Image& b, int tolerance) {
  std::int64_t count = 0;
  for (int y = 0; y < a.height(); ++y) {
    for (int x = 0; x < a.width(); ++x) count += has_like(a, b, x, y, tolerance) ? 0 : 1;
  }
  return count;
}

/// Returns the width of a file without a size: to the end of its ink.
double ink_width_mm(const PaintedScene& scene) {
  double width = 0.0;
  for (const SvgShape& shape : scene.shapes) {
    const double beside = shape.line ? 0.5 * shape.line->width * std::fabs(shape.to_mm.a) : 0.0;
    for (const SvgContour& c : shape.contours) {
      for (const Point& p : c.points) width = std::max(width, apply(shape.to_mm, p).x + beside);
    }
  }
  return width;
}

}  // namespace

Result<PaintedScene> paint_scene(std::string_view svg) {
  PaintedScene scene;
  Collector collector(scene);
  if (auto ok = read_svg_scene(svg, collector); !ok) return tl::unexpected(ok.error());
  return scene;
}

Result<Image> scene_picture(const PaintedScene& scene, int width_px, int height_px) {
  Result<Image> image = Image::create(width_px, height_px);
  if (!image) return image;
  const double width_mm = scene.root.width_mm.value_or(ink_width_mm(scene));
  fill(image->pixels(), image->pixels().rect(), scene.paper);
  const double px_per_mm = width_mm > 0.0 ? width_px / width_mm : 96.0 / 25.4;
  Painter painter(*image, px_per_mm);
  for (std::size_t i = 0; i < scene.shapes.size();) {
    const SvgShape& first = scene.shapes[i];
    std::size_t end = i + 1;
    while (end < scene.shapes.size() && first.group != 0 &&
           scene.shapes[end].group == first.group) {
      ++end;
    }
    Image group = Image::create(width_px, height_px).value();
    Painter in_group(group, px_per_mm);
    for (; i < end; ++i) (first.group == 0 ? painter : in_group).paint(scene.shapes[i]);
    if (first.group == 0) continue;
    blend(group.pixels(), group.pixels().rect(), first.group_opacity, BlendMode::kNormal,
          scene.paper, image->pixels());
  }
  return image;
}

std::int64_t pixels_apart(const Image& a, const Image& b, int tolerance) {
  if (a.width() != b.width() || a.height() != b.height()) return -1;
  return pixels_without_like(a, b, tolerance) + pixels_without_like(b, a, tolerance);
}

}  // namespace felt::testing
