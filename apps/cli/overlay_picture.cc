#include "overlay_picture.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <utility>
#include <vector>

#include "felt/document/visible_strokes.h"
#include "felt/io/svg/svg_compact.h"
#include "felt/render/page_painter.h"
#include "felt/render/plot.h"
#include "felt/render/plot_canvas.h"
#include "felt/render/raster.h"
#include "felt/tools/guide_picture.h"
#include "felt/tools/overlay_look.h"
#include "svg_canvas.h"

namespace felt::cli {
namespace {

using Role = Overlay::Role;

constexpr double kUnitsPerInch = 150.0;
constexpr double kOverlayMarginMm = 5.0;
constexpr double kBandMm = 1.6;  // width that the band of a marked span adds to its ink
constexpr double kTextSize = 8.0;
constexpr Rgba kTextColor{30, 30, 34, 255};
constexpr Rgba kTextHalo{255, 255, 255, 225};
constexpr Rgba kPenColor{20, 20, 24, 255};

/// Mixes the colour with white. The result is opaque, so that overlaps of the pieces of a band are
/// not visible.
Rgba pale(Rgba color, double share) {
  const auto mixed = [share](std::uint8_t c) {
    return static_cast<std::uint8_t>(std::lround(255.0 + share * (c - 255.0)));
  };
  return {mixed(color.r), mixed(color.g), mixed(color.b), 255};
}

/// Converts text to plain ASCII, because the font has no other characters.
std::string ascii(const std::string& text) {
  static constexpr std::array<std::pair<std::string_view, std::string_view>, 4> kSpelled{
      {{"\u00b0", " deg"}, {"\u00d7", "x"}, {"\u2192", "->"}, {"\u00b1", "+-"}}};
  std::string plain;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const std::string_view rest = std::string_view(text).substr(i);
    const auto* const spelled = std::find_if(
        kSpelled.begin(), kSpelled.end(), [&](const auto& s) { return rest.starts_with(s.first); });
    if (spelled != kSpelled.end()) {
      plain += spelled->second;
      i += spelled->first.size() - 1;
    } else if (text[i] >= ' ' && text[i] <= '~') {
      plain += text[i];
    } else if ((static_cast<unsigned char>(text[i]) & 0xC0U) != 0x80U) {
      plain += '?';
    }
  }
  return plain;
}

/// Draws the overlay on a PlotCanvas or an SvgCanvas. Positions are in mm, widths in units of the
/// picture.
template <class Canvas>
class OverlayPen {
 public:
  /// `size_px` is that of the picture. Requires that `canvas` outlives this.
  OverlayPen(Canvas& canvas, const View& view, double px_per_unit, Vec size_px)
      : canvas_(canvas),
        view_(view),
        px_per_unit_(px_per_unit),
        width_units_(size_px.x / px_per_unit),
        height_units_(size_px.y / px_per_unit),
        far_units_(20.0 * (width_units_ + height_units_)) {}

  void bands(const Overlay& overlay) {
    for (const auto& span : overlay.spans) {
      const double width = (span.width_mm + kBandMm) * view_.px_per_mm / px_per_unit_;
      curve(span.curve, {std::max(width, 5.0), pale(role_color(span.role), 0.5)});
    }
  }
  void marks(const Overlay& overlay) {
    for (const auto& outline : overlay.outlines) this->outline(outline);
    for (const auto& ring : overlay.rings) this->ring(ring.center, ring.radius_mm, ring.role);
    for (const auto& line : overlay.lines) this->line(line);
    for (const auto& dot : overlay.dots) this->dot(dot);
    for (const auto& label : overlay.labels) this->label(label);
  }
  /// Draws a small circle with a dot in it.
  void pen(Point at) {
    const Vec c = units(at);
    circle(c, 3.4, {3.4, {255, 255, 255, 205}});
    circle(c, 3.4, {1.5, kPenColor});
    circle(c, 0.5, {1.2, kPenColor});
  }

 private:
  [[nodiscard]] Vec units(Point p) const { return (1.0 / px_per_unit_) * view_.to_px(p); }
  /// Returns true if a point is so far away that it is not visible. Drawing a dashed line to it
  /// would never end.
  [[nodiscard]] bool is_far(Vec p) const {
    return !(std::abs(p.x) < far_units_ && std::abs(p.y) < far_units_);
  }
  [[nodiscard]] static PlotPen pen_of(Role role) {
    const RoleLook look = look_of(role);
    return {look.width, plot_color(look.color), look.dashed ? 4.0 : 0.0, look.dashed ? 3.6 : 0.0};
  }
  [[nodiscard]] bool shows(Vec p) const {
    return p.x >= 0.0 && p.x <= width_units_ && p.y >= 0.0 && p.y <= height_units_;
  }
  void polyline(const std::vector<Vec>& points, const PlotPen& pen) {
    if (std::none_of(points.begin(), points.end(), [this](Vec p) { return is_far(p); })) {
      canvas_.polyline(points, pen);
    }
  }
  void curve(const Cubic& c, const PlotPen& pen) {
    constexpr int kSteps = 24;
    std::vector<Vec> points;
    for (int i = 0; i <= kSteps; ++i) {
      points.push_back(units(evaluate(c, static_cast<double>(i) / kSteps)));
    }
    polyline(points, pen);
  }
  void circle(Vec center, double radius, const PlotPen& pen) {
    const int steps = static_cast<int>(std::clamp(3.0 * radius, 16.0, 240.0));
    std::vector<Vec> points;
    for (int i = 0; i <= steps; ++i) {
      const double angle = 2.0 * std::numbers::pi * i / steps;
      points.push_back(center + radius * Vec{std::cos(angle), std::sin(angle)});
    }
    polyline(points, pen);
  }
  void ring(Point center, double radius_mm, Role role) {
    circle(units(center), radius_mm * view_.px_per_mm / px_per_unit_, pen_of(role));
  }
  void line(const Overlay::Line& line) {
    const Vec from = units(line.from), to = units(line.to);
    polyline({from, to}, pen_of(line.role));
    if (line.role == Role::kVector) arrow_head(from, to);
  }
  void arrow_head(Vec from, Vec to) {
    const Vec way = to - from;
    if (norm(way) < 4.0) return;
    const Vec back = (-std::min(7.0, 0.5 * norm(way)) / norm(way)) * way;
    const Vec side = 0.45 * Vec{-back.y, back.x};
    polyline({to + back + side, to, to + back - side}, pen_of(Role::kVector));
  }
  void outline(const Overlay::Outline& outline) {
    std::vector<Vec> points;
    for (const Point& p : outline.points) points.push_back(units(p));
    if (outline.closed && !points.empty()) points.push_back(points.front());
    polyline(points, pen_of(outline.role));
  }
  void dot(const Overlay::Dot& dot) {
    const Vec at = units(dot.at);
    circle(at, 1.2, {4.4, {255, 255, 255, 255}});
    circle(at, 1.2, {2.4, role_color(dot.role)});
  }
  void label(const Overlay::Label& label) {
    const std::string text = ascii(label.text);
    const Vec place = units(label.at);
    if (!shows(place))
      return;  // the point is outside, and half a word at the edge would be
               // confusing
    Vec at = place + Vec{6.0, -6.0};
    // Draws the label on the other side of the point if it does not fit into the picture.
    const double width = canvas_.text_width(text, kTextSize);
    if (at.x + width > width_units_) at.x = std::max(2.0, at.x - width - 12.0);
    canvas_.text(at, text, {kTextSize, kTextHalo, PlotAlign::kLeft, 4.2});
    canvas_.text(at, text, {kTextSize, kTextColor, PlotAlign::kLeft, 1.1});
  }

  Canvas& canvas_;
  View view_;
  double px_per_unit_;
  double width_units_, height_units_;
  double far_units_;
};

/// Returns each segment of wet ink as a stroke of its own, which is good enough for a picture.
std::vector<StrokePtr> wet_ink(const Overlay& overlay) {
  std::vector<Affine> images{Affine{}};
  images.insert(images.end(), overlay.ink_images.begin(), overlay.ink_images.end());
  std::vector<StrokePtr> strokes;
  for (const Affine& image : images) {
    for (const Overlay::InkSegment& original : overlay.ink) {
      const Overlay::InkSegment wet = mapped(original, image);
      StrokeData data;
      data.points.assign(wet.curve.p.begin(), wet.curve.p.end());
      data.widths = {{0.0, std::max(wet.start_width_mm, kMinWidthMm), wet.start_tone},
                     {1.0, std::max(wet.end_width_mm, kMinWidthMm), wet.end_tone}};
      data.color = overlay.ink_color;
      Result<Stroke> ink = Stroke::create(std::move(data));
      if (ink) strokes.push_back(std::make_shared<const Stroke>(*std::move(ink)));
    }
  }
  return strokes;
}

/// Returns the area of the page that a picture shows.
Rect shown_area(const SessionView& view, const PictureOptions& options) {
  const Rect area = options.area.value_or(bounds_of(view).inflated(kOverlayMarginMm));
  return area.empty() ? page_area(ink_bounds(view.document), {}) : area;
}

/// Draws what is above the ink.
template <class Canvas>
void draw_marks(OverlayPen<Canvas>& pen, const SessionView& view, const Rect& area) {
  Overlay guides;
  add_guide_pictures(guides, view.document, nullptr, area);
  pen.marks(guides);
  pen.marks(view.overlay);
  if (view.pen) pen.pen(*view.pen);
}

}  // namespace

SessionView view_of(const Session& session, std::optional<Point> pen) {
  SessionView view;
  view.pen = pen;
  session.draw(view.overlay);
  view.document = session.document();
  // If the preview is invalid, that is a bug of the tool, and its commit will report it.
  if (session.preview()) (void)view.document.apply(*session.preview_with_fills());
  return view;
}

Rect bounds_of(const SessionView& view) {
  Rect box = ink_bounds(view.document);
  for (const auto& wet : view.overlay.ink) {
    box.extend(bounds(wet.curve));
    for (const Affine& image : view.overlay.ink_images)
      box.extend(bounds(mapped(wet, image).curve));
  }
  for (const auto& ring : view.overlay.rings) {
    box.extend(
        Rect{ring.center.x, ring.center.y, ring.center.x, ring.center.y}.inflated(ring.radius_mm));
  }
  for (const auto& outline : view.overlay.outlines) {
    for (const Point& p : outline.points) box.extend(p);
  }
  for (const DrawingGuidePtr& guide : view.document.visible_guides()) {
    const Rect extent = guide_extent(*guide);
    if (!extent.empty()) box.extend(extent);
  }
  if (view.pen) box.extend(*view.pen);
  return box;
}

Rgba role_color(Overlay::Role role) noexcept {
  return plot_color(look_of(role).color);
}

Result<Image> draw_view(const SessionView& view, const PictureOptions& options, double scale) {
  PageOptions page;
  page.dpi = options.dpi;
  page.area = shown_area(view, options);
  page.paper = options.paper.value_or(page.paper);
  Result<PagePainter> painter = PagePainter::create({}, page);
  if (!painter) return tl::unexpected(painter.error());
  const Pixels pixels = painter->image().pixels();
  const double px_per_unit = scale * page.dpi / kUnitsPerInch;
  PlotCanvas canvas(pixels, px_per_unit);
  OverlayPen pen(canvas, painter->view(), px_per_unit,
                 {static_cast<double>(pixels.width), static_cast<double>(pixels.height)});
  pen.bands(view.overlay);
  if (Result<void> drawn = painter->draw(view.document, PictureChoice::kMarked); !drawn) {
    return tl::unexpected(drawn.error());
  }
  Rasterizer rasterizer;
  for (const StrokePtr& wet : wet_ink(view.overlay)) {
    rasterizer.draw(*wet, painter->view(), pixels.rect(), pixels);
  }
  draw_marks(pen, view, *page.area);
  return std::move(painter->image());
}

Result<std::string> view_svg(const SessionView& view, const PictureOptions& options, double scale) {
  const Rect area = shown_area(view, options);
  const double units_per_mm = kUnitsPerInch / kMmPerInch / scale;
  const std::string group =
      fmt::format("<g transform=\"translate({:.3f} {:.3f}) scale({:.5f})\">\n", area.x0, area.y0,
                  1.0 / units_per_mm);
  std::string text;
  append_compact_head(text, area, options.paper.value_or(Rgba{255, 255, 255, 255}));
  SvgCanvas canvas(text);
  OverlayPen pen(canvas, View{{area.x0, area.y0}, units_per_mm}, 1.0,
                 units_per_mm * Vec{area.width(), area.height()});
  text += group;
  pen.bands(view.overlay);
  text += "</g>\n";
  for (const Document& ink : {view.document, document_of(wet_ink(view.overlay))}) {
    if (Result<void> done = append_compact_ink(text, {.document = ink}); !done)
      return tl::unexpected(done.error());
  }
  text += group;
  draw_marks(pen, view, area);
  return text + "</g>\n</svg>\n";
}

}  // namespace felt::cli
