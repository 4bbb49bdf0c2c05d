#include "felt/io/svg/svg_compact.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "felt/document/visible_strokes.h"
#include "felt/io/drawing_styles.h"
#include "felt/io/fill_path.h"
#include "felt/io/ndjson/ndjson_writer.h"
#include "felt/io/svg/svg_elements.h"
#include "felt/render/styled_outline.h"
#include "felt/stroke/color_text.h"

namespace felt {
namespace {

constexpr double kCompactToleranceMm = 0.02;
constexpr double kCompactStepsPerMm = 100.0;

double rounded(double mm) noexcept {
  return std::round(mm * kCompactStepsPerMm) / kCompactStepsPerMm;
}

/// Returns the attributes of a colour. Black is the default of SVG.
std::string fill_of(Rgba color) {
  std::string text;
  const Rgba opaque{color.r, color.g, color.b, 255};
  if (opaque != Rgba{}) text += " fill=\"" + color_to_text(opaque) + "\"";
  if (color.a == 255) return text;
  text += " fill-opacity=\"";
  append_number(text, std::round(color.a * (1e3 / 255.0)) / 1e3);
  return text + "\"";
}

/// Returns x, y, width and height of the area, separated by blanks.
std::string box_text(const Rect& area) {
  std::string text;
  for (const double mm : {area.x0, area.y0, area.width(), area.height()}) {
    if (!text.empty()) text += ' ';
    append_number(text, rounded(mm));
  }
  return text;
}

void append_compact_path(std::string& out, const Stroke& stroke, const StrokeStyles& styles,
                         std::string_view fill) {
  OutlinePath path = styled_path(stroke, styles.find(stroke.medium()), kCompactToleranceMm);
  for (Point& p : path.points) p = {rounded(p.x), rounded(p.y)};
  out += "<path";
  out += fill;
  out += " d=\"";
  append_path_data(out, path);
  out += "\"/>\n";
}

/// Appends the strokes. Neighbours of the same colour are in a group that has the colour. They are
/// not one path, because outlines that overlap could cancel each other.
Result<void> append_strokes(std::string& out, const std::vector<StrokePtr>& strokes,
                            const StrokeStyles& styles) {
  for (std::size_t i = 0; i < strokes.size();) {
    std::size_t end = i + 1;
    while (end < strokes.size() && strokes[end]->color() == strokes[i]->color()) ++end;
    const std::string fill = fill_of(strokes[i]->color());
    const bool is_group = end > i + 1 && !fill.empty();
    if (is_group) out += "<g" + fill + ">\n";
    for (; i < end; ++i) {
      const Rect box = strokes[i]->bounds();
      if (!(box.x0 >= -kMaxCoordinateMm && box.y0 >= -kMaxCoordinateMm &&
            box.x1 <= kMaxCoordinateMm && box.y1 <= kMaxCoordinateMm)) {
        return fail(ErrorCode::kLimitExceeded,
                    "stroke " + std::to_string(i + 1) + ": the stroke extends beyond 1e9 mm");
      }
      append_compact_path(out, *strokes[i], styles, is_group ? "" : fill);
    }
    if (is_group) out += "</g>\n";
  }
  return {};
}

/// Begins a group with an opacity and a blend mode.
void append_whole_begin(std::string& out, double opacity, BlendMode blend) {
  out += "<g";
  if (opacity < 1.0) {
    out += " opacity=\"";
    append_number(out, std::round(opacity * 1e3) / 1e3);
    out += '"';
  }
  if (blend != BlendMode::kNormal) {
    out += " style=\"mix-blend-mode:";
    out += blend_mode_name(blend);
    out += '"';
  }
  out += ">\n";
}

Result<void> append_fills(std::string& out, const Document& document, const Layer& layer) {
  for (const FillId id : layer.fills) {
    const Fill& fill = *document.find_fill(id);
    const Rect box = fill_bounds(fill);
    if (std::max({-box.x0, -box.y0, box.x1, box.y1}) > kMaxCoordinateMm) {
      return fail(ErrorCode::kLimitExceeded, fill_name(id) + ": the fill extends beyond 1e9 mm");
    }
    OutlinePath path = fill_path(fill);
    for (Point& p : path.points) p = {rounded(p.x), rounded(p.y)};
    out += "<path" + fill_of(fill.color) + " fill-rule=\"evenodd\" d=\"";
    append_path_data(out, path);
    out += "\"/>\n";
  }
  return {};
}

}  // namespace

// Strokes of neighbouring layers can share a group, unless one of the layers has fills or is drawn
// as a whole.
Result<void> append_compact_ink(std::string& out, const Drawing& drawing) {
  const Document& document = drawing.document;
  const StrokeStyles styles = styles_of(drawing);
  std::vector<StrokePtr> strokes;
  LayerGroupPtr open;  // the group of layers that has begun, if it is drawn as a whole
  const auto flush = [&] { return append_strokes(out, std::exchange(strokes, {}), styles); };
  for (const Layer& layer : document.layers()) {
    if (!layer.visible) continue;
    const LayerGroupPtr group = layer.group && layer.group->is_whole() ? layer.group : nullptr;
    const bool is_whole = layer.opacity < 1.0 || layer.blend != BlendMode::kNormal;
    const bool is_next = !equal_groups(group, open);
    if (is_whole || is_next || !layer.fills.empty()) {
      if (auto ok = flush(); !ok) return ok;
    }
    if (is_next && open) out += "</g>\n";
    if (is_next && group) append_whole_begin(out, group->opacity, group->blend);
    open = group;
    if (is_whole) append_whole_begin(out, layer.opacity, layer.blend);
    if (auto ok = append_fills(out, document, layer); !ok) return ok;
    for (const StrokeId id : layer.strokes) strokes.push_back(document.find(id));
    if (!is_whole) continue;
    if (auto ok = flush(); !ok) return ok;
    out += "</g>\n";
  }
  if (auto ok = flush(); !ok) return ok;
  if (open) out += "</g>\n";
  return {};
}

void append_compact_head(std::string& out, const Rect& area, Rgba paper) {
  out += "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"";
  append_number(out, rounded(area.width()));
  out += "mm\" height=\"";
  append_number(out, rounded(area.height()));
  out += "mm\" viewBox=\"" + box_text(area) + "\">\n";
  if (paper.a > 0) {
    out += "<path" + fill_of(paper) + " d=\"M";
    append_number(out, rounded(area.x0));
    out += ' ';
    append_number(out, rounded(area.y0));
    out += 'h';
    append_number(out, rounded(area.width()));
    out += 'v';
    append_number(out, rounded(area.height()));
    out += 'h';
    append_number(out, -rounded(area.width()));
    out += "z\"/>\n";
  }
}

Result<std::string> svg_compact_text(const Drawing& drawing, const SvgOptions& options) {
  const bool shows_page = drawing.has_page && !options.area;
  const Rect area =
      shows_page ? drawing.page.area()
                 : picture_area(ink_bounds(drawing.document), options.area, options.margin_mm);
  const Rgba paper = options.paper.value_or(shows_page ? drawing.page.paper : Rgba{0, 0, 0, 0});
  std::string text;
  append_compact_head(text, area, paper);
  if (Result<void> done = append_compact_ink(text, drawing); !done) {
    return tl::unexpected(done.error());
  }
  text += "</svg>\n";
  return text;
}

}  // namespace felt
