#include "convert_drawing.h"

#include <algorithm>
#include <charconv>
#include <memory>
#include <utility>
#include <vector>

#include "felt/document/visible_strokes.h"
#include "felt/formats/drawing_writer.h"
#include "felt/formats/format_traits.h"
#include "felt/formats/layered_drawing.h"
#include "felt/io/svg_writer.h"
#include "felt/render/page.h"
#include "sketch_output.h"

namespace felt::cli {
namespace {

/// The layer of a number or a name; layers.size() where there is none.
std::size_t find_layer(std::string_view text, const std::vector<SketchLayer>& layers) {
  std::size_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error == std::errc() && end == text.data() + text.size()) {
    return number >= 1 && number <= layers.size() ? number - 1 : layers.size();
  }
  const auto named = std::find_if(layers.begin(), layers.end(),
                                  [text](const SketchLayer& l) { return l.name == text; });
  return static_cast<std::size_t>(named - layers.begin());
}

tl::unexpected<Error> no_layer(std::string_view text, const std::vector<SketchLayer>& layers) {
  constexpr std::size_t kMostNamed = 20;
  std::string there;
  for (std::size_t i = 0; i < std::min(layers.size(), kMostNamed); ++i) {
    there += (i > 0 ? ", " : "") + std::to_string(i + 1) + " '" + layers[i].name + "'";
  }
  if (layers.size() > kMostNamed) there += ", ...";
  return fail(ErrorCode::kNotFound,
              "--layers: there is no layer '" + std::string(text) + "'; there are " + there);
}

/// Which layers stay, by their place.
Result<std::vector<bool>> chosen_layers(const std::string& text,
                                        const std::vector<SketchLayer>& layers) {
  std::vector<bool> chosen(layers.size(), text == "all");
  if (text == "all") return chosen;
  if (text == "visible") {
    for (std::size_t i = 0; i < layers.size(); ++i) chosen[i] = layers[i].visible;
    return chosen;
  }
  // The name of one layer may hold commas.
  if (const std::size_t one = find_layer(text, layers); one < layers.size()) {
    chosen[one] = true;
    return chosen;
  }
  for (std::string_view rest = text;;) {
    const std::string_view word = rest.substr(0, rest.find(','));
    const std::size_t layer = find_layer(word, layers);
    if (layer == layers.size()) return no_layer(word, layers);
    chosen[layer] = true;
    if (word.size() == rest.size()) return chosen;
    rest.remove_prefix(word.size() + 1);
  }
}

constexpr double kMarginMm = 5.0;

/// All ink and a margin, as the streaming outputs show it.
Rect ink_area(const Document& document, Format format) {
  const Rect ink = ink_bounds(visible_strokes(document));
  if (format == Format::kSvg) return svg_area(ink, SvgOptions{.margin_mm = kMarginMm});
  return (ink.empty() ? Rect{0.0, 0.0, 0.0, 0.0} : ink).inflated(kMarginMm);
}

/// The part that a picture shows; none: the page, which becomes the sheet that was asked for.
Result<std::optional<Rect>> shown_area(OpenedDrawing& opened, Format format,
                                       const PictureOptions& picture) {
  const bool is_picture = traits_of(format).picture;
  if (!picture.sheet) {
    const bool whole_ink = is_picture && (picture.fit || !opened.has_page);
    return whole_ink ? std::optional(ink_area(opened.drawing.document, format)) : std::nullopt;
  }
  if (Result<SheetPage> page = sheet_page(*picture.sheet, opened.drawing.page.paper)) {
    page->surface = opened.drawing.page.surface;
    opened.drawing.page = *page;
    return std::nullopt;
  } else if (!is_picture) {
    return tl::unexpected(page.error());
  }
  return picture.sheet;  // a picture may be of any size
}

/// As a stream of lines is written: what `convert` gives does not depend on what it was given.
Result<void> write_lines(const std::string& path, const Sketch& sketch,
                         const PictureOptions& picture) {
  Result<std::unique_ptr<SketchOutput>> output = open_sketch_output(path, Format::kNdjson, picture);
  if (!output) return tl::unexpected(output.error());
  return write_strokes(sketch, Format::kNdjson, **output);
}

}  // namespace

Result<void> choose_layers(const std::string& text, StoredDrawing& drawing) {
  if (text.empty()) return {};
  LayeredSketch sketch = layered_sketch(drawing);
  const Result<std::vector<bool>> chosen = chosen_layers(text, sketch.layers);
  if (!chosen) return tl::unexpected(chosen.error());
  LayeredSketch kept;
  kept.page = sketch.page;
  for (std::size_t i = 0; i < sketch.layers.size(); ++i) {
    if (!(*chosen)[i]) continue;
    kept.layers.push_back(std::move(sketch.layers[i]));
    kept.layers.back().visible = true;
  }
  StoredDrawing result = stored_drawing(std::move(kept));
  drawing.document = std::move(result.document);
  drawing.layer = {};
  return {};
}

Result<void> write_opened(const std::string& path, OpenedDrawing opened, Format format,
                          const PictureOptions& asked) {
  PictureOptions picture = asked;
  if (auto ok = use_surface_of(opened.drawing, picture); !ok) return ok;
  WriteOptions options;
  if (picture.wants_grain) options.grain_print = GrainPrint{picture.grain, picture.grain_dpi};
  options.dpi = picture.dpi;
  options.grain = picture.grain;
  options.no_page = !opened.has_page && !picture.sheet;
  const Result<std::optional<Rect>> area = shown_area(opened, format, picture);
  if (!area) return tl::unexpected(area.error());
  options.area = *area;
  if (picture.paper) {
    opened.drawing.page.paper = *picture.paper;
  } else if (!opened.has_page && format != Format::kPng) {
    options.paper = Rgba{255, 255, 255, 0};
  }
  if (format == Format::kNdjson) {
    return write_lines(path, visible_strokes(opened.drawing.document), picture);
  }
  return write_drawing(path, opened.drawing, format, options);
}

}  // namespace felt::cli
