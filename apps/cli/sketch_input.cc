#include "sketch_input.h"

#include <fmt/core.h>

#include "felt/formats/line_drawing.h"

namespace felt::cli {
namespace {

constexpr std::size_t kSketchBatchBytes = std::size_t{64} << 10;

/// Reads the lines of a sketch.
struct SketchLines {
  Format format;
  LineStrokes strokes{};
  ImportReport report{};     // the faults of samples
  std::int64_t records = 0;  // lines so far
  std::int64_t headers = 0;  // lines so far that are no strokes
  std::int64_t mended = 0;

  /// Adds the stroke of a line to a piece. Skips a header.
  Result<void> add(const NdjsonLine& line, EncodedStrokes& piece) {
    ++records;
    Result<std::optional<NamedStroke>> stroke = strokes.read(line);
    if (!stroke) return tl::unexpected(stroke.error());
    if (!*stroke) {
      ++headers;
      return {};
    }
    if ((*stroke)->id.empty()) (*stroke)->id = fmt::format("s{}", records);
    report.add_faults(line.number(), (*stroke)->id, strokes.faults());
    if (auto ok = encode(**stroke, records - headers, format, piece); !ok) return ok;
    mended += strokes.was_mended() ? 1 : 0;
    return {};
  }
};

}  // namespace

bool for_each_piece(const Input& input, Format format, Console& console,
                    const std::function<bool(const EncodedStrokes&)>& take) {
  LineReader reader(input.reader());
  LineBatch batch;
  SketchLines sketch{format};
  EncodedStrokes piece;
  Result<bool> more = reader.fill(batch, kSketchBatchBytes);
  for (; more && *more; more = reader.fill(batch, kSketchBatchBytes)) {
    piece.clear();
    for (std::size_t i = 0; i < batch.size(); ++i) {
      const NdjsonLine line = batch.line(i);
      const Result<void> added = sketch.add(line, piece);
      if (added) continue;
      console.record_error(input.name(), line.number(), added.error().message);
    }
    if (!piece.text.empty() && !take(piece)) return false;
    console.progress("reading", reader.bytes_read(), input.size_bytes(), sketch.records);
  }
  console.end_progress();
  console.end_records();
  if (sketch.mended > 0) {
    console.notice(fmt::format("{}: {} of {} lines: {}", input.name(), sketch.mended,
                               sketch.records, kMendedNotice));
  }
  for (const ImportNotice& notice : sketch.report.notices()) {
    console.notice(input.name() + ": " + notice_text(notice));
  }
  if (!more) console.error(input.name() + ": " + more.error().message);
  if (more && sketch.records == 0) console.error(input.name() + ": contains no strokes");
  return true;
}

bool report_notices(const std::string& name, const ImportReport& report, Console& console) {
  for (const ImportNotice& notice : report.notices()) {
    console.notice(name + ": " + notice_text(notice));
  }
  return !console.failed();
}

void note_refusals(const std::string& name, const Refusals& refusals, Console& console) {
  if (refusals.gestures == 0) return;
  console.notice(fmt::format("{}: {} {} of the pen changed nothing: {}", name, refusals.gestures,
                             refusals.gestures == 1 ? "gesture" : "gestures", refusals.first));
}

}  // namespace felt::cli
