#include "felt/io/quickdraw/quickdraw_import.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "felt/geometry/rect.h"
#include "felt/io/drawing_builder.h"
#include "felt/io/ink_of_points.h"
#include "felt/io/limits.h"
#include "felt/io/quickdraw/quickdraw_line.h"

namespace felt {
namespace {

constexpr std::size_t kReadBytes = std::size_t{64} << 10;
constexpr double kSquare = 255.0;  // units of the simplified drawings
constexpr double kInset = 0.5 * (kQuickdrawCellMm - kSquare * kQuickdrawMmPerUnit);

class QuickdrawReader {
 public:
  explicit QuickdrawReader(const ImportOptions& options) : ink_(solid_fit(options.fit)) {}

  void add(const NdjsonLine& line) {
    if (records_.size() == static_cast<std::size_t>(kMaxQuickdrawDrawings)) {
      report_.add(line.number(), "drawing",
                  "was skipped: a contact sheet holds " + std::to_string(kMaxQuickdrawDrawings));
      return;
    }
    QuickdrawRecord record;
    if (const Result<void> done = parser_.parse(line, record); !done) {
      if (first_error_.empty()) first_error_ = done.error().message;
      report_.add(line.number(), "", "is not a drawing and was skipped: " + done.error().message);
      return;
    }
    records_.push_back(std::move(record));
    lines_.push_back(line.number());
  }

  Result<Imported> finish() {
    if (records_.empty()) {
      return fail(ErrorCode::kInvalidData, first_error_.empty()
                                               ? "contains no drawing"
                                               : "contains no drawing: " + first_error_);
    }
    const auto count = static_cast<int>(records_.size());
    const int columns = static_cast<int>(std::ceil(std::sqrt(count)));
    for (int i = 0; i < count; ++i) {
      add_layer(i, {kQuickdrawCellMm * (i % columns), kQuickdrawCellMm * (i / columns)});
    }
    Drawing& drawing = builder_.drawing();
    drawing.has_page = true;
    drawing.page.width_mm = kQuickdrawCellMm * columns;
    drawing.page.height_mm = kQuickdrawCellMm * ((count + columns - 1) / columns);
    return Imported{std::move(builder_).build(), std::move(report_)};
  }

 private:
  /// The position of a drawing in its cell.
  struct Placing {
    Point origin{0.0, 0.0};
    double scale = kQuickdrawMmPerUnit;
  };

  // Simplified drawings already lie in their square. Others are moved and scaled into it, as the
  // data set did to make the simplified ones.
  static Placing placing_of(const QuickdrawRecord& record) {
    Rect box;
    for (const auto& stroke : record.strokes) {
      for (const InkSample& s : stroke) box.extend(s.position);
    }
    Placing placing;
    if (box.x0 < 0.0 || box.y0 < 0.0 || box.x1 > kSquare || box.y1 > kSquare) {
      placing.origin = {box.x0, box.y0};
      const double side = std::max(box.width(), box.height());
      placing.scale *= side > 0.0 ? kSquare / side : 1.0;
    }
    return placing;
  }

  void add_layer(int index, Point corner) {
    QuickdrawRecord& record = records_[static_cast<std::size_t>(index)];
    const Placing placing = placing_of(record);
    const std::string name =
        record.word.empty() ? "Drawing " + std::to_string(index + 1) : record.word;
    const std::size_t layer = builder_.add_layer({name});
    for (std::vector<InkSample>& samples : record.strokes) {
      restore_simplified(samples);
      for (InkSample& s : samples) {
        s.position = corner + Vec{kInset, kInset} + placing.scale * (s.position - placing.origin);
      }
      Result<StrokeData> data = ink_.of_samples(samples);
      Result<Stroke> stroke =
          data ? Stroke::create(*std::move(data)) : tl::unexpected(data.error());
      if (!stroke) {
        report_.add(lines_[static_cast<std::size_t>(index)], "a stroke of '" + name + "'",
                    "was skipped: " + stroke.error().message);
        continue;
      }
      report_.add_faults(lines_[static_cast<std::size_t>(index)], name, ink_.sample_faults());
      builder_.add(layer, *std::move(stroke));
      std::vector<InkSample>().swap(samples);
    }
    record = {};
  }

  InkOfPoints ink_;
  QuickdrawParser parser_;
  std::vector<QuickdrawRecord> records_;
  std::vector<std::int64_t> lines_;
  std::string first_error_;
  DrawingBuilder builder_;
  ImportReport report_;
};

}  // namespace

Result<Imported> import_quickdraw(std::string_view text, const ImportOptions& options) {
  if (text.size() > limits::kMaxImportBytes) {
    return fail(ErrorCode::kLimitExceeded, "is larger than 256 MiB");
  }
  QuickdrawReader reader(options);
  LineReader lines(read_text(text));
  LineBatch batch;
  for (;;) {
    const Result<bool> more = lines.fill(batch, kReadBytes);
    if (!more) return tl::unexpected(more.error());
    if (!*more) break;
    for (std::size_t i = 0; i < batch.size(); ++i) reader.add(batch.line(i));
  }
  return reader.finish();
}

}  // namespace felt
