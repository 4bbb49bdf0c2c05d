#include "felt/io/svg_writer.h"

#include <cmath>
#include <utility>

#include "felt/io/svg_text.h"

namespace felt {

Rect svg_area(const Rect& ink, const SvgOptions& options) noexcept {
  if (options.sheet) return *options.sheet;
  const Rect area = (ink.empty() ? Rect{0.0, 0.0, 0.0, 0.0} : ink).inflated(options.margin_mm);
  return {std::floor(area.x0 * 100.0) / 100.0, std::floor(area.y0 * 100.0) / 100.0,
          std::ceil(area.x1 * 100.0) / 100.0, std::ceil(area.y1 * 100.0) / 100.0};
}

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
  append_svg_head(writer.text_, svg_area({}, options), options.paper);
  return writer;
}

Result<void> SvgWriter::add(const SketchStroke& stroke) {
  if (auto ok = append_svg_stroke(text_, stroke, count_ + 1, options_.tolerance_mm); !ok) {
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
  append_svg_tail(text_);
  if (auto ok = file_.write(text_); !ok) return ok;
  std::string head;
  append_svg_head(head, svg_area(ink_, options_), options_.paper);
  if (auto ok = file_.overwrite(0, head); !ok) return ok;
  return file_.commit();
}

namespace {

/// Strokes one after another, numbered from 1.
class Strokes {
 public:
  Strokes(const SvgOptions& options, const Rect& area) : tolerance_mm_(options.tolerance_mm) {
    if (options.grain) masks_.emplace(*options.grain, area);
  }

  Result<void> append(std::string& text, const Sketch& strokes) {
    for (const SketchStroke& s : strokes) {
      if (auto ok = append(text, s); !ok) {
        return tl::unexpected(with_context(ok.error(), "stroke " + std::to_string(number_)));
      }
    }
    return {};
  }

 private:
  Result<void> append(std::string& text, const SketchStroke& s) {
    ++number_;
    if (!masks_) return append_svg_stroke(text, s, number_, tolerance_mm_);
    const Result<std::optional<GrainMask>> mask = masks_->of(s.stroke);
    if (!mask) return tl::unexpected(mask.error());
    return append_svg_stroke(text, s, number_, tolerance_mm_, *mask ? &**mask : nullptr);
  }

  double tolerance_mm_;
  std::optional<GrainMasks> masks_;
  std::size_t number_ = 0;
};

}  // namespace

Result<std::string> svg_text(const Sketch& sketch, const SvgOptions& options) {
  Rect ink;
  for (const SketchStroke& s : sketch) ink.extend(s.stroke.bounds());
  const Rect area = svg_area(ink, options);
  std::string text;
  append_svg_head(text, area, options.paper);
  if (auto ok = Strokes(options, area).append(text, sketch); !ok) return tl::unexpected(ok.error());
  append_svg_tail(text);
  return text;
}

Result<std::string> svg_text(const LayeredSketch& drawing, const SvgOptions& options) {
  Rect ink;
  for (const SketchLayer& layer : drawing.layers) {
    for (const SketchStroke& s : layer.strokes) ink.extend(s.stroke.bounds());
  }
  const std::optional<SheetPage>& page = drawing.page;
  const Result<std::string> model = svg_model_text(drawing);
  if (!model) return tl::unexpected(model.error());
  const Rect area = page ? page->area() : svg_area(ink, options);
  std::string text;
  append_svg_head(text, area, page ? page->paper : options.paper, *model);
  Strokes strokes(options, area);
  for (std::size_t i = 0; i < drawing.layers.size(); ++i) {
    const SketchLayer& layer = drawing.layers[i];
    auto ok = append_svg_layer_begin(text, layer, i + 1);
    if (ok) ok = strokes.append(text, layer.strokes);
    if (!ok) {
      return tl::unexpected<Error>(with_context(ok.error(), "layer " + std::to_string(i + 1)));
    }
    append_svg_layer_end(text);
  }
  append_svg_tail(text);
  return text;
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
