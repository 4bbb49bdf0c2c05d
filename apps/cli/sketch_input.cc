#include "sketch_input.h"

#include <fmt/core.h>

#include "felt/formats/line_drawing.h"

namespace felt::cli {
namespace {

constexpr std::size_t kSketchBatchBytes = std::size_t{64} << 10;

/// Adds one line to a piece, and the faults of its samples to `report`. Skips a header.
Result<void> add_line(LineStrokes& strokes, const NdjsonLine& line, std::int64_t number,
                      Format format, EncodedStrokes& piece, ImportReport& report) {
  Result<std::optional<NamedStroke>> stroke = strokes.read(line);
  if (!stroke) return tl::unexpected(stroke.error());
  if (!*stroke) return {};
  if ((*stroke)->id.empty()) (*stroke)->id = fmt::format("s{}", number);
  report.add_faults(line.number(), (*stroke)->id, strokes.faults());
  return encode(**stroke, number, format, piece);
}

}  // namespace

bool for_each_piece(const Input& input, Format format, Console& console,
                    const std::function<bool(const EncodedStrokes&)>& take) {
  LineReader reader(input.reader());
  LineBatch batch;
  LineStrokes strokes;
  EncodedStrokes piece;
  std::int64_t records = 0;
  std::int64_t mended = 0;
  ImportReport report;
  Result<bool> more = reader.fill(batch, kSketchBatchBytes);
  for (; more && *more; more = reader.fill(batch, kSketchBatchBytes)) {
    piece.clear();
    for (std::size_t i = 0; i < batch.size(); ++i) {
      const NdjsonLine line = batch.line(i);
      const Result<void> added = add_line(strokes, line, ++records, format, piece, report);
      mended += added && strokes.was_mended() ? 1 : 0;
      if (added) continue;
      console.record_error(input.name(), line.number(), added.error().message);
    }
    if (!piece.text.empty() && !take(piece)) return false;
    console.progress("reading", reader.bytes_read(), input.size_bytes(), records);
  }
  console.end_progress();
  console.end_records();
  if (mended > 0) {
    console.notice(
        fmt::format("{}: {} of {} lines: {}", input.name(), mended, records, kMendedNotice));
  }
  for (const ImportNotice& notice : report.notices()) {
    console.notice(input.name() + ": " + notice_text(notice));
  }
  if (!more) console.error(input.name() + ": " + more.error().message);
  if (more && records == 0) console.error(input.name() + ": contains no strokes");
  return true;
}

bool report_notices(const std::string& name, const ImportReport& report, Console& console) {
  for (const ImportNotice& notice : report.notices()) {
    console.notice(name + ": " + notice_text(notice));
  }
  return !console.failed();
}

}  // namespace felt::cli
