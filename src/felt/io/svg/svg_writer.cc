#include "felt/io/svg/svg_writer.h"

#include <cmath>
#include <utility>

#include "felt/io/svg/svg_text.h"

namespace felt {

SvgWriter::SvgWriter(AtomicFile file, const SvgOptions& options)
    : file_(std::move(file)), options_(options) {}

Result<SvgWriter> SvgWriter::create(const std::string& path, const SvgOptions& options) {
  if (!(options.tolerance_mm > 0.0) || !(options.margin_mm >= 0.0) ||
      (options.sheet && options.sheet->empty())) {
    return fail(ErrorCode::kInvalidArgument,
                "SVG: the tolerance must be above 0, the margin 0 or more, the sheet not empty");
  }
  auto file = AtomicFile::create(path);
  if (!file) return tl::unexpected<Error>(std::move(file.error()));
  SvgWriter writer(*std::move(file), options);
  append_svg_head(writer.text_, picture_area({}, options.sheet, options.margin_mm), options.paper);
  append_svg_group_begin(writer.text_);
  return writer;
}

Result<void> SvgWriter::add(const SketchStroke& stroke) {
  if (auto ok =
          append_svg_stroke(text_, stroke.id, stroke.stroke, count_ + 1, options_.tolerance_mm);
      !ok) {
    return tl::unexpected<Error>(with_context(ok.error(), "stroke " + std::to_string(count_ + 1)));
  }
  ++count_;
  return add_text({}, stroke.stroke.bounds());
}

Result<void> SvgWriter::add_text(std::string_view strokes, const Rect& ink) {
  text_ += strokes;
  ink_.extend(ink);
  auto done = file_.write(text_);
  text_.clear();
  return done;
}

Result<void> SvgWriter::finish() {
  append_svg_group_end(text_);
  append_svg_tail(text_);
  if (auto ok = file_.write(text_); !ok) return ok;
  std::string head;
  append_svg_head(head, picture_area(ink_, options_.sheet, options_.margin_mm), options_.paper);
  if (auto ok = file_.overwrite(0, head); !ok) return ok;
  return file_.commit();
}

namespace {

/// Part 0 is the head; then the strokes, the layers' tags with the first and the last of each.
class SvgParts final : public DrawingParts {
 public:
  SvgParts(DrawingView drawing, const SvgOptions& options, const Rect& area, std::string head,
           bool layered)
      : drawing_(std::move(drawing)),
        ranges_(stroke_ranges(drawing_)),
        tolerance_mm_(options.tolerance_mm),
        head_(std::move(head)),
        is_layered_(layered) {
    if (options.grain) masks_.emplace(*options.grain, area);
  }

  [[nodiscard]] std::size_t count() const override { return ranges_.size() + 1; }
  // Masks share a budget of pixels.
  [[nodiscard]] bool any_order() const override { return !masks_; }

  Result<void> make(std::size_t i, DrawingPart& out) const override {
    out.clear();
    if (i == 0) {
      out.bytes = head_;
      return {};
    }
    const StrokeRange& range = ranges_[i - 1];
    auto ok = append(out.bytes, range);
    if (ok || !is_layered_) return ok;
    return tl::unexpected(with_context(ok.error(), "layer " + std::to_string(range.layer + 1)));
  }

  std::string tail() override {
    std::string text;
    append_svg_tail(text);
    return text;
  }

 private:
  Result<void> append(std::string& text, const StrokeRange& range) const {
    const LayerView& layer = drawing_.layers[range.layer];
    if (range.first == 0) {
      if (auto ok = begin(text, layer, range.layer + 1); !ok) return ok;
    }
    for (std::size_t i = range.first; i < range.last; ++i) {
      const std::size_t number = range.before + (i - range.first) + 1;
      if (auto ok = append_stroke(text, layer, i, number); !ok) {
        return tl::unexpected(with_context(ok.error(), "stroke " + std::to_string(number)));
      }
    }
    if (range.last == layer.count) append_svg_group_end(text);
    return {};
  }

  Result<void> begin(std::string& text, const LayerView& layer, std::size_t number) const {
    if (is_layered_) return append_svg_layer_begin(text, layer, number);
    append_svg_group_begin(text);
    return {};
  }

  Result<void> append_stroke(std::string& text, const LayerView& layer, std::size_t i,
                             std::size_t number) const {
    const Stroke& stroke = layer.stroke(i);
    if (!masks_) return append_svg_stroke(text, layer.id(i), stroke, number, tolerance_mm_);
    const Result<std::optional<GrainMask>> mask = masks_->of(stroke);
    if (!mask) return tl::unexpected(mask.error());
    return append_svg_stroke(text, layer.id(i), stroke, number, tolerance_mm_,
                             *mask ? &**mask : nullptr);
  }

  DrawingView drawing_;
  std::vector<StrokeRange> ranges_;
  double tolerance_mm_;
  std::string head_;
  bool is_layered_;
  mutable std::optional<GrainMasks> masks_;  // of one thread: any_order()
};

}  // namespace

Result<std::unique_ptr<DrawingParts>> svg_parts(DrawingView drawing, const SvgOptions& options) {
  const std::optional<SheetPage> page = drawing.page;
  const Result<std::string> model = svg_model_text(drawing);
  if (!model) return tl::unexpected(model.error());
  const Rect area =
      page ? page->area() : picture_area(drawing.ink(), options.sheet, options.margin_mm);
  std::string head;
  append_svg_head(head, area, page ? page->paper : options.paper, *model);
  return std::make_unique<SvgParts>(std::move(drawing), options, area, std::move(head), true);
}

Result<std::string> svg_text(const Sketch& sketch, const SvgOptions& options) {
  DrawingView drawing = view_of(sketch);
  const Rect area = picture_area(drawing.ink(), options.sheet, options.margin_mm);
  std::string head;
  append_svg_head(head, area, options.paper);
  SvgParts parts(std::move(drawing), options, area, std::move(head), false);
  return bytes_of(parts);
}

Result<std::string> svg_text(const LayeredSketch& drawing, const SvgOptions& options) {
  const Result<std::unique_ptr<DrawingParts>> parts = svg_parts(view_of(drawing), options);
  if (!parts) return tl::unexpected(parts.error());
  return bytes_of(**parts);
}

Result<void> write_svg(const std::string& path, const Sketch& sketch, const SvgOptions& options) {
  auto writer = SvgWriter::create(path, options);
  if (!writer) return tl::unexpected<Error>(std::move(writer.error()));
  for (const SketchStroke& s : sketch) {
    if (auto ok = writer->add(s); !ok) return ok;
  }
  return writer->finish();
}

}  // namespace felt
