#include "felt/io/svg/svg_compact.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "felt/document/visible_strokes.h"
#include "felt/io/fill_path.h"
#include "felt/io/ndjson/ndjson_writer.h"
#include "felt/io/svg/svg_elements.h"
#include "felt/stroke/color_text.h"
#include "felt/stroke/outline/outline_path.h"

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

void append_compact_path(std::string& out, const Stroke& stroke, std::string_view fill) {
  OutlinePath path = outline_path(stroke, kCompactToleranceMm);
  for (Point& p : path.points) p = {rounded(p.x), rounded(p.y)};
  out += "<path";
  out += fill;
  out += " d=\"";
  append_path_data(out, path);
  out += "\"/>\n";
}

/// Appends the strokes. Neighbours of the same colour are in a group that has the colour. They are
/// not one path, because outlines that overlap could cancel each other.
Result<void> append_strokes(std::string& out, const std::vector<StrokePtr>& strokes) {
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
      append_compact_path(out, *strokes[i], is_group ? "" : fill);
    }
    if (is_group) out += "</g>\n";
  }
  return {};
}

/// Appends the visible layers. Strokes of neighbouring layers without fills can share a group.
Result<void> append_layers(std::string& out, const Document& document) {
  std::vector<StrokePtr> strokes;
  const auto flush = [&] { return append_strokes(out, std::exchange(strokes, {})); };
  for (const Layer& layer : document.layers()) {
    if (!layer.visible) continue;
    if (!layer.fills.empty()) {
      if (auto ok = flush(); !ok) return ok;
    }
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
    for (const StrokeId id : layer.strokes) strokes.push_back(document.find(id));
  }
  return flush();
}

}  // namespace

Result<std::string> svg_compact_text(const Drawing& drawing, const SvgOptions& options) {
  const bool shows_page = drawing.has_page && !options.area;
  const Rect area =
      shows_page ? drawing.page.area()
                 : picture_area(ink_bounds(drawing.document), options.area, options.margin_mm);
  const Rgba paper = options.paper.value_or(shows_page ? drawing.page.paper : Rgba{0, 0, 0, 0});
  std::string text = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"";
  append_number(text, rounded(area.width()));
  text += "mm\" height=\"";
  append_number(text, rounded(area.height()));
  text += "mm\" viewBox=\"" + box_text(area) + "\">\n";
  if (paper.a > 0) {
    text += "<path" + fill_of(paper) + " d=\"M";
    append_number(text, rounded(area.x0));
    text += ' ';
    append_number(text, rounded(area.y0));
    text += 'h';
    append_number(text, rounded(area.width()));
    text += 'v';
    append_number(text, rounded(area.height()));
    text += 'h';
    append_number(text, -rounded(area.width()));
    text += "z\"/>\n";
  }
  if (Result<void> done = append_layers(text, drawing.document); !done) {
    return tl::unexpected(done.error());
  }
  text += "</svg>\n";
  return text;
}

}  // namespace felt
