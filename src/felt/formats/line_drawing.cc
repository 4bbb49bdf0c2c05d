#include "felt/formats/line_drawing.h"

#include <utility>

#include "felt/formats/file_format.h"
#include "felt/io/drawing_builder.h"
#include "felt/io/ndjson/ndjson_writer.h"
#include "felt/io/quickdraw/quickdraw_line.h"
#include "felt/stroke/edit/mend_joints.h"

namespace felt {
namespace {

constexpr std::size_t kBatchBytes = std::size_t{64} << 10;

Result<std::optional<NamedStroke>> named(std::string id, Result<Stroke> stroke) {
  if (!stroke) return tl::unexpected(stroke.error());
  return NamedStroke{std::move(id), *std::move(stroke)};
}

}  // namespace

Result<std::optional<NamedStroke>> LineStrokes::read(const NdjsonLine& line) {
  was_mended_ = false;
  faults_ = {};
  const std::string_view text = line.text();
  if (looks_like_quickdraw(text)) return fail(ErrorCode::kUnsupported, kUnknownQuickdraw);
  const bool is_raw = text.find("\"points\"") != std::string_view::npos &&
                      text.find("\"segments\"") == std::string_view::npos;
  return is_raw ? read_raw(line) : read_fitted(line);
}

Result<std::optional<NamedStroke>> LineStrokes::read_fitted(const NdjsonLine& line) {
  SketchRecord record;
  const Result<NdjsonKind> kind = parser_.sketch_stroke(line, record);
  if (!kind) return tl::unexpected(kind.error());
  if (*kind == NdjsonKind::kHeader) return std::nullopt;
  was_mended_ = mend_rounding(record.data).any();
  return named(std::move(record.id), Stroke::create(std::move(record.data)));
}

Result<std::optional<NamedStroke>> LineStrokes::read_raw(const NdjsonLine& line) {
  const Result<NdjsonKind> kind = parser_.raw_stroke(line, raw_);
  if (!kind) return tl::unexpected(kind.error());
  if (*kind == NdjsonKind::kHeader) return std::nullopt;
  fitter_.begin();
  for (const InkSample& sample : raw_.samples) fitter_.push(sample);
  fitter_.end();
  fitter_.refine();
  faults_ = fitter_.faults();
  return named(raw_.id, fitter_.stroke());
}

Result<Imported> import_lines(std::string_view text, const ImportOptions& options) {
  if (ndjson_content(text.substr(0, kFormatHeadBytes)) == NdjsonContent::kEvents) {
    return fail(ErrorCode::kUnsupported,
                "contains events, not strokes; use `feltline replay` to draw them");
  }
  LineReader lines(read_text(text));
  LineBatch batch;
  LineStrokes strokes(options.fit);
  DrawingBuilder builder;
  const std::size_t layer = builder.add_layer({"Ink"});
  std::size_t count = 0, records = 0;
  ImportReport report;
  for (;;) {
    const Result<bool> more = lines.fill(batch, kBatchBytes);
    if (!more) return tl::unexpected(more.error());
    if (!*more) break;
    for (std::size_t i = 0; i < batch.size(); ++i) {
      const NdjsonLine line = batch.line(i);
      ++records;
      Result<std::optional<NamedStroke>> stroke = strokes.read(line);
      if (!stroke) {
        report.add(line.number(), {}, "was skipped: " + stroke.error().message);
      } else if (*stroke) {
        NamedStroke& named = **stroke;
        if (named.id.empty()) named.id = stroke_name({records});
        if (strokes.was_mended()) {
          report.add(line.number(), "stroke '" + named.id + "'", kMendedNotice);
        }
        report.add_faults(line.number(), named.id, strokes.faults());
        builder.add(layer, std::move(named.stroke), named.id);
        ++count;
      }
    }
  }
  if (count == 0 && !report.empty()) {
    return fail(ErrorCode::kInvalidData, notice_text(report.notices().front()));
  }
  return Imported{std::move(builder).build(), std::move(report)};
}

namespace {

class LineParts final : public DrawingParts {
 public:
  explicit LineParts(const Drawing& drawing)
      : drawing_(drawing), ranges_(stroke_ranges(drawing.document, LayerChoice::kVisible)) {}

  [[nodiscard]] std::size_t count() const override { return ranges_.size(); }
  Result<void> make(std::size_t i, DrawingPart& out) const override {
    out.clear();
    const StrokeRange& range = ranges_[i];
    const Layer& layer = drawing_.document.layers()[range.layer];
    for (std::size_t k = range.first; k < range.last; ++k) {
      const std::string name = name_in_file(drawing_, layer.strokes[k]);
      const StrokePtr stroke = drawing_.document.find(layer.strokes[k]);
      if (auto fits = check_sketch_numbers(stroke->data()); !fits) {
        return tl::unexpected(with_context(fits.error(), "stroke " + name));
      }
      append_sketch_line(out.bytes, name, stroke->data());
    }
    return {};
  }

 private:
  const Drawing& drawing_;
  std::vector<StrokeRange> ranges_;
};

}  // namespace

std::unique_ptr<DrawingParts> line_parts(const Drawing& drawing) {
  return std::make_unique<LineParts>(drawing);
}

}  // namespace felt
