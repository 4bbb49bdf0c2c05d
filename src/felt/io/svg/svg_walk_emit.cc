// Computes how a shape of an SVG file is painted, and passes it to the sink.
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "felt/io/svg/svg_document.h"
#include "felt/io/svg/svg_elements.h"
#include "felt/io/svg/svg_scan.h"
#include "felt/io/svg/svg_style.h"
#include "felt/io/svg/svg_walk.h"
#include "felt/stroke/stroke.h"

namespace felt {
namespace {

/// The single colour that replaces a gradient or pattern: for a gradient the mean of its colours
/// from 0 to 1, for a pattern grey. The colour is missing if the element is not a paint, or if it
/// is a gradient without stops. `current` is the value of currentColor.
struct SvgServerColor {
  bool paints = false;  ///< the id is that of a gradient, pattern or similar
  std::optional<Rgba> color;
  bool is_gradient = false;
  bool is_solid = false;  ///< solidColor of SVG Tiny: exactly that colour
};
SvgServerColor svg_server_color(SvgDocument& document, std::string_view id, Rgba current);

constexpr int kMaxLinks = 16;
/// Maximum number of children that are searched for stops. It is limited because every shape may
/// repeat the search.
constexpr int kMaxChildren = 100;

/// Computes the mean of a gradient from stop to stop. Colours are weighted by their alpha.
class GradientMean {
 public:
  void add(double offset, Rgba color) {
    offset = std::clamp(offset, at_, 1.0);
    if (is_first_)
      add_span(offset, color, color);
    else
      add_span(offset - at_, last_, color);
    is_first_ = false;
    at_ = offset;
    last_ = color;
  }

  [[nodiscard]] std::optional<Rgba> color() {
    if (is_first_) return std::nullopt;
    add_span(1.0 - at_, last_, last_);
    at_ = 1.0;
    const auto byte = [](double value) {
      return static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0, 255.0)));
    };
    if (!(alpha_ > 0.0)) return Rgba{last_.r, last_.g, last_.b, 0};
    return Rgba{byte(sum_[0] / alpha_), byte(sum_[1] / alpha_), byte(sum_[2] / alpha_),
                byte(alpha_)};
  }

 private:
  /// Adds a span in which the colour changes linearly from a to b. The mean of such a span is half
  /// of each colour.
  void add_span(double length, Rgba a, Rgba b) {
    for (const Rgba c : {a, b}) {
      const double weight = 0.5 * length * c.a;
      alpha_ += weight;
      sum_[0] += weight * c.r;
      sum_[1] += weight * c.g;
      sum_[2] += weight * c.b;
    }
  }

  std::array<double, 3> sum_{};
  double alpha_ = 0.0, at_ = 0.0;
  Rgba last_{};
  bool is_first_ = true;
};

Rgba stop_color(SvgDocument& document, const pugi::xml_node& stop, Rgba current) {
  SvgDeclared declared;
  std::string clean;
  static_cast<void>(svg_declared(stop, document.style_sheet(), clean, declared));
  const std::string_view text = declared[SvgProperty::kStopColor];
  Rgba color{0, 0, 0, 255};
  if (svg_same_word(text, "currentColor")) {
    color = svg_color(declared[SvgProperty::kColor]).value_or(current);
  } else if (const std::optional<Rgba> said = svg_color(text)) {
    color = *said;
  }
  return svg_faded(color, svg_share(declared[SvgProperty::kStopOpacity]).value_or(1.0));
}

Rgba solid_color(SvgDocument& document, const pugi::xml_node& node, Rgba current) {
  SvgDeclared declared;
  std::string clean;
  static_cast<void>(svg_declared(node, document.style_sheet(), clean, declared));
  const std::string_view text = declared[SvgProperty::kSolidColor];
  if (svg_same_word(text, "currentColor")) return current;
  const double opacity = svg_share(node.attribute("solid-opacity").value()).value_or(1.0);
  return svg_faded(svg_color(text).value_or(Rgba{0, 0, 0, 255}), opacity);
}

SvgServerColor svg_server_color(SvgDocument& document, std::string_view id, Rgba current) {
  SvgServerColor result;
  for (int links = 0; links < kMaxLinks; ++links) {
    const pugi::xml_node node = document.find(id);
    const std::string_view name = document.svg_name(node, true);
    if (name == "pattern" || name == "hatch" || name == "mesh" || name == "meshgradient") {
      result.paints = true;
      result.color = Rgba{128, 128, 128, 255};
      return result;
    }
    if (name == "solidColor" || name == "solidcolor") {
      result.paints = result.is_solid = true;
      result.color = solid_color(document, node, current);
      return result;
    }
    if (name != "linearGradient" && name != "radialGradient") return result;
    result.paints = result.is_gradient = true;
    int children = 0;
    GradientMean mean;
    for (const pugi::xml_node child : node.children()) {
      if (++children > kMaxChildren) break;
      if (document.svg_name(child, true) != "stop") continue;
      mean.add(svg_share(child.attribute("offset").value()).value_or(0.0),
               stop_color(document, child, current));
    }
    result.color = mean.color();
    if (result.color) return result;
    const std::string_view next = svg_href(node);
    if (next.empty() || next.front() != '#') return result;
    id = next.substr(1);
  }
  return result;
}

}  // namespace

namespace {

/// Returns the factor for the lengths of dashes. It is not 1 if the file specifies the length of
/// the path (pathLength), because dashes are then in units of that length.
double path_length_scale(const char* path_length, std::span<const SvgContour> contours) {
  const std::optional<double> written = svg_length(path_length, SvgAxis::kDiagonal, SvgUnits());
  if (!written || !(*written > 0.0)) return 1.0;
  double length = 0.0;
  for (const SvgContour& c : contours) {
    for (std::size_t i = 0; i < c.segment_count(); ++i) length += arc_length(c.segment(i));
  }
  return length > 0.0 ? length / *written : 1.0;
}

/// Returns true if a shape is an upright rectangle, drawn once or several times, or has no extent.
/// Without paint, icons contain such shapes as their frame.
bool is_frame(std::span<const SvgContour> contours) {
  Rect box;
  for (const SvgContour& c : contours) {
    for (const Point& p : c.points) box.extend(p);
  }
  const double size = std::max(box.width(), box.height());
  if (contours.empty() || !(size > 0.0)) return true;
  const auto same = [size](double a, double b) { return std::fabs(a - b) <= 1e-3 * size; };
  std::array<bool, 4> corners{};
  for (const SvgContour& c : contours) {
    if (contours.size() == 1 && c.points.front() != c.points.back()) return false;
    for (std::size_t i = 0; i < c.points.size(); ++i) {
      const Point p = c.points[i];
      const bool on_x = same(p.x, box.x0) || same(p.x, box.x1);
      const bool on_y = same(p.y, box.y0) || same(p.y, box.y1);
      // Control points lie on a side between the corners.
      if (i % 3 == 0 ? !(on_x && on_y) : !(on_x || on_y)) return false;
      if (i % 3 == 0) corners[(same(p.x, box.x1) ? 1 : 0) + (same(p.y, box.y1) ? 2 : 0)] = true;
    }
  }
  return corners == std::array{true, true, true, true};
}

}  // namespace

std::optional<Rgba> SvgWalker::paint_color(const SvgPaint& paint, const Element& e,
                                           double opacity) {
  using Kind = SvgPaint::Kind;
  const SvgStyle& style = e.state.style;
  const auto plain = [&](Kind kind, Rgba color) -> std::optional<Rgba> {
    if (kind == Kind::kColor) return color;
    return kind == Kind::kCurrent ? std::optional(style.color) : std::nullopt;
  };
  std::optional<Rgba> color = plain(paint.kind, paint.color);
  if (paint.kind == Kind::kServer) {
    const SvgServerColor server = svg_server_color(document_, paint.server, style.color);
    if (!server.paints || !server.color) {
      color = plain(paint.fallback, paint.fallback_color);
    } else if (server.is_solid) {
      color = server.color;
    } else if (server.is_gradient) {
      color = server.color;
      notice(e.node, "is painted with a gradient; the mean colour of its stops was used");
    } else {
      color = plain(paint.fallback, paint.fallback_color);
      if (!color) color = server.color;
      notice(e.node, "is painted with a pattern; a single colour was used");
    }
  }
  if (!color) return std::nullopt;
  const Rgba faded = svg_faded(*color, opacity * e.state.opacity);
  return faded.a == 0 ? std::nullopt : std::optional(faded);
}

std::optional<SvgVariableWidth> SvgWalker::variable_width(const Element& e) const {
  if (e.name != "path") return std::nullopt;
  SvgVariableWidth v;
  v.center_line = document_.inkscape(e.node, "original-d");
  if (v.center_line.empty()) return std::nullopt;
  v.widths = document_.ours(e.node, "widths");
  v.tones = document_.ours(e.node, "tones");
  v.is_ours = !v.widths.empty();
  v.points = document_.ours(e.node, "points");
  v.id = document_.ours(e.node, "id");
  // Since version 2, the id of the stroke is that of the element, unless our own is given.
  if (v.id.data() == nullptr && !v.points.empty()) v.id = e.node.attribute("id").value();
  v.number = document_.ours(e.node, "number");
  v.medium = document_.ours(e.node, "material");
  if (v.medium.data() == nullptr && !v.points.empty()) v.medium = kSvgUsualMaterial;
  v.closed = document_.ours(e.node, "closed");
  v.joints = document_.ours(e.node, "joints");
  SvgScan effects(document_.inkscape(e.node, "path-effect"));
  bool has_other = false;
  while (!effects.empty()) {
    const std::string_view one = svg_trimmed(effects.until(';'));
    if (one.empty() || one.front() != '#') continue;
    const pugi::xml_node effect = document_.find(one.substr(1));
    if (!effect || svg_same_word(effect.attribute("is_visible").value(), "false")) continue;
    const std::string_view kind = effect.attribute("effect").value();
    v.has_pattern = v.has_pattern || (kind == "skeletal" && !v.has_effect);
    if (kind != "powerstroke" || v.has_effect) {
      has_other = true;
      continue;
    }
    v.has_effect = true;
    v.offset_points = effect.attribute("offset_points").value();
    v.interpolator = effect.attribute("interpolator_type").value();
    v.interpolator_beta = effect.attribute("interpolator_beta").value();
    v.scale_width = effect.attribute("scale_width").value();
    v.start_cap = effect.attribute("start_linecap_type").value();
    v.end_cap = effect.attribute("end_linecap_type").value();
  }
  // Other effects change the line that the widths belong to. Then `d` shows the result.
  if (!v.is_ours && (!v.has_effect || has_other)) return std::nullopt;
  return v;
}

/// Sets the line of a shape, if it has one.
void SvgWalker::draw_line(const Element& e, SvgShape& shape) {
  const SvgStyle& style = e.state.style;
  const auto color = paint_color(style.stroke, e, style.stroke_opacity);
  if (!color || !(style.stroke_width > 0.0)) return;
  SvgLine& line = shape.line.emplace(SvgLine{
      *color, style.stroke_width, style.cap, style.join, style.miter_limit, {}, style.dash_offset});
  double dash_scale = 1.0;
  if (style.dashes) {
    line.dashes = *style.dashes;
    dash_scale = path_length_scale(e.node.attribute("pathLength").value(), shape.contours);
  }
  // With non-scaling-stroke, the width does not scale with the transform: 1 px is 1/96 inch on the
  // page.
  const double scale = std::sqrt(std::fabs(determinant(shape.to_mm))) / kSvgMmPerPx;
  if (!style.scales_line && scale > 0.0) {
    line.width /= scale;
    if (dash_scale == 1.0) dash_scale = 1.0 / scale;
  }
  line.dash_offset *= dash_scale;
  for (double& dash : line.dashes) dash *= dash_scale;
}

void SvgWalker::emit(Element& e, std::vector<SvgContour> contours) {
  const SvgStyle& style = e.state.style;
  SvgShape shape;
  shape.element = e.name;
  shape.id = e.node.attribute("id").value();
  shape.line_number = document_.line_of(e.node);
  shape.contours = std::move(contours);
  shape.to_mm = e.state.to_mm;
  shape.frame = e.state.frame;
  shape.group = e.state.group;
  shape.group_opacity = e.state.group_opacity;
  shape.variable_width = variable_width(e);
  shape.pieces = document_.ours(e.node, "fill");
  if (const auto color = paint_color(style.fill, e, style.fill_opacity);
      color && e.name != "line") {
    shape.fill = SvgFill{*color, style.even_odd};
  }
  shape.is_cut = e.state.is_cut;
  draw_line(e, shape);
  const bool is_ink = shape.variable_width && shape.variable_width->is_ours;
  if (is_ink) {
    shape.variable_width->color =
        svg_faded(style.fill.kind == SvgPaint::Kind::kCurrent ? style.color : style.fill.color,
                  style.fill_opacity * e.state.opacity);
  }
  if (style.has_marker) notice(e.node, "has markers, which were skipped");
  if (!shape.pieces.empty() && !shape.fill && style.fill.kind == SvgPaint::Kind::kColor) {
    shape.fill = SvgFill{svg_faded(style.fill.color, style.fill_opacity * e.state.opacity), true};
  }
  if (!shape.fill && !shape.line && !is_ink) {
    // A frame whose line is switched off by its width alone was drawn as a line.
    const bool is_thin = style.stroke.kind != SvgPaint::Kind::kNone && !(style.stroke_width > 0.0);
    if (!style.has_marker && (is_thin || !is_frame(shape.contours))) {
      notice(e.node, "has neither a line nor a fill that shows and was skipped");
    }
    return;
  }
  if (shape.fill && shape.line && style.reorders_paint) {
    notice(e.node, "paints its line below its fill, which was ignored");
  }
  begin_content(e);
  sink_.shape(std::move(shape));
}

}  // namespace felt
