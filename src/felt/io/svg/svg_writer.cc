#include "felt/io/svg/svg_writer.h"

#include <utility>

#include "felt/io/drawing_styles.h"
#include "felt/io/svg/svg_elements.h"
#include "felt/io/xml/xml_text.h"

namespace felt {

namespace {

constexpr Rgba kNoPaper{255, 255, 255, 0};

enum class SvgLayers { kWritten, kLeftOut };

/// Part 0 is the head. The other parts contain the strokes. The first part of a layer also contains
/// the start tag of the layer, and the last part its end tag. The same applies to groups of layers.
class SvgParts final : public DrawingParts {
 public:
  SvgParts(const Drawing& drawing, const SvgOptions& options, const Rect& area, std::string head,
           SvgLayers layers)
      : document_(drawing.document),
        names_(drawing),
        styles_(options.grain ? options.grain->grain.styles() : styles_of(drawing)),
        ranges_(stroke_ranges(drawing.document, LayerChoice::kAll)),
        tolerance_mm_(options.tolerance_mm),
        pictures_(options.pictures),
        head_(std::move(head)),
        layers_(layers) {
    if (options.grain) masks_.emplace(*options.grain, area);
  }

  [[nodiscard]] std::size_t count() const override { return ranges_.size() + 1; }
  // All masks share a budget of pixels, so they must be made in order.
  [[nodiscard]] bool any_order() const override { return !masks_; }

  Result<void> make(std::size_t i, DrawingPart& out) const override {
    out.clear();
    if (i == 0) {
      out.bytes = head_;
      return {};
    }
    const StrokeRange& range = ranges_[i - 1];
    auto ok = append(out.bytes, range);
    if (ok || layers_ == SvgLayers::kLeftOut) return ok;
    return tl::unexpected(with_context(ok.error(), "layer " + std::to_string(range.layer + 1)));
  }

  std::string tail() override {
    std::string text;
    append_svg_tail(text);
    return text;
  }

 private:
  Result<void> append(std::string& text, const StrokeRange& range) const {
    const Layer& layer = document_.layers()[range.layer];
    if (range.first == 0) {
      if (auto ok = begin(text, layer, range.layer + 1); !ok) return ok;
    }
    for (std::size_t i = range.first; i < range.last; ++i) {
      const std::size_t number = range.before + (i - range.first) + 1;
      if (auto ok = append_stroke(text, layer.strokes[i], number); !ok) {
        return tl::unexpected(with_context(ok.error(), "stroke " + std::to_string(number)));
      }
    }
    if (range.last < layer.strokes.size()) return {};
    append_svg_group_end(text);
    const bool is_last = range.layer + 1 == document_.layers().size() ||
                         !same_group(layer.group, document_.layers()[range.layer + 1].group);
    if (layer.group && is_last && layers_ == SvgLayers::kWritten) append_svg_group_end(text);
    return {};
  }

  Result<void> begin(std::string& text, const Layer& layer, std::size_t number) const {
    if (layers_ == SvgLayers::kLeftOut) {
      append_svg_group_begin(text);
      return {};
    }
    const bool is_first =
        number == 1 || !same_group(layer.group, document_.layers()[number - 2].group);
    if (layer.group && is_first) {
      if (auto ok = append_svg_layer_group_begin(text, *layer.group); !ok) return ok;
    }
    if (auto ok = append_svg_layer_begin(text, layer, number); !ok) return ok;
    // Also that of a hidden layer, which is written as hidden.
    const bool has_picture =
        layer.picture && (pictures_ == PictureChoice::kAll || layer.picture->exported);
    if (has_picture) append_svg_picture(text, *layer.picture);
    for (const FillId id : layer.fills) {
      if (auto ok = append_svg_fill(text, fill_name(id), *document_.find_fill(id)); !ok) return ok;
    }
    return {};
  }

  Result<void> append_stroke(std::string& text, StrokeId id, std::size_t number) const {
    const StrokePtr stroke = document_.find(id);
    const StrokeStyle* style = styles_.find(stroke->medium());
    const auto [name, own_number] = names_.of(id);
    if (!masks_) {
      return append_svg_stroke(text, {name, own_number}, *stroke, number, tolerance_mm_, nullptr,
                               style);
    }
    const Result<std::optional<GrainMask>> mask = masks_->of(*stroke);
    if (!mask) return tl::unexpected(mask.error());
    return append_svg_stroke(text, {name, own_number}, *stroke, number, tolerance_mm_,
                             *mask ? &**mask : nullptr, style);
  }

  const Document& document_;
  XmlStrokeNames names_;
  StrokeStyles styles_;
  std::vector<StrokeRange> ranges_;
  double tolerance_mm_;
  PictureChoice pictures_;
  std::string head_;
  SvgLayers layers_;
  mutable std::optional<GrainMasks> masks_;  // one thread only, because any_order() is false
};

}  // namespace

namespace {

/// Returns the page that the file shows, or nullopt if it shows an area.
std::optional<Page> shown_page(const Drawing& drawing, const SvgOptions& options) {
  if (!drawing.has_page || options.area) return std::nullopt;
  Page page = drawing.page;
  page.paper = options.paper.value_or(page.paper);
  return page;
}

Rect shown_area(const Drawing& drawing, const SvgOptions& options, const Rect& ink) {
  const std::optional<Page> page = shown_page(drawing, options);
  return page ? page->area() : picture_area(ink, options.area, options.margin_mm);
}

}  // namespace

Result<std::string> svg_head(const Drawing& drawing, const SvgOptions& options, const Rect& ink) {
  const std::optional<Page> page = shown_page(drawing, options);
  const Result<std::string> model = svg_model_text(drawing, page ? &*page : nullptr);
  if (!model) return tl::unexpected(model.error());
  std::string head;
  append_svg_head(head, shown_area(drawing, options, ink),
                  page ? page->paper : options.paper.value_or(kNoPaper), *model);
  return head;
}

Result<std::unique_ptr<DrawingParts>> svg_parts(const Drawing& drawing, const SvgOptions& options) {
  const Rect ink = ink_bounds(drawing.document, LayerChoice::kAll);
  return svg_head(drawing, options, ink).map([&](std::string head) {
    return std::unique_ptr<DrawingParts>(std::make_unique<SvgParts>(
        drawing, options, shown_area(drawing, options, ink), std::move(head), SvgLayers::kWritten));
  });
}

Result<std::string> svg_text(const Drawing& drawing, const SvgOptions& options) {
  const Result<std::unique_ptr<DrawingParts>> parts = svg_parts(drawing, options);
  if (!parts) return tl::unexpected(parts.error());
  return bytes_of(**parts);
}

Result<std::string> svg_ink_text(const Drawing& drawing, const SvgOptions& options) {
  const Rect area = picture_area(ink_bounds(drawing.document, LayerChoice::kAll), options.area,
                                 options.margin_mm);
  std::string head;
  append_svg_head(head, area, options.paper.value_or(kNoPaper));
  SvgParts parts(drawing, options, area, std::move(head), SvgLayers::kLeftOut);
  return bytes_of(parts);
}

}  // namespace felt
