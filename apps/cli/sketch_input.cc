#include "sketch_input.h"

#include <fmt/core.h>

#include "felt/io/ndjson_parser.h"
#include "input.h"
#include "stored_sketch.h"

namespace felt::cli {
namespace {

constexpr std::size_t kBatchBytes = std::size_t{64} << 10;

/// Adds one line to a piece; nothing for a header.
Result<void> add_line(NdjsonParser& parser, const NdjsonLine& line, std::int64_t number,
                      Format format, SketchPiece& piece) {
  SketchRecord record;
  const Result<NdjsonKind> kind = parser.sketch_stroke(line, record);
  if (!kind) return tl::unexpected(kind.error());
  if (*kind == NdjsonKind::kHeader) return {};
  Result<Stroke> stroke = Stroke::create(std::move(record.data));
  if (!stroke) return tl::unexpected(stroke.error());
  if (record.id.empty()) record.id = fmt::format("s{}", number);
  return encode({std::move(record.id), *std::move(stroke)}, number, format, piece);
}

/// Reads an open input piece by piece; false when `take` returned false.
bool read_pieces(const Input& input, Format format, Console& console,
                 const std::function<bool(const SketchPiece&)>& take) {
  LineReader reader(input.reader());
  LineBatch batch;
  NdjsonParser parser;
  SketchPiece piece;
  std::int64_t records = 0;
  Result<bool> more = reader.fill(batch, kBatchBytes);
  for (; more && *more; more = reader.fill(batch, kBatchBytes)) {
    piece.clear();
    for (std::size_t i = 0; i < batch.size(); ++i) {
      const NdjsonLine line = batch.line(i);
      const Result<void> added = add_line(parser, line, ++records, format, piece);
      if (added) continue;
      console.error(fmt::format("{}:{}: {}", input.name(), line.number(), added.error().message));
    }
    if (!piece.text.empty() && !take(piece)) return false;
    console.progress("reading", reader.bytes_read(), input.size_bytes(), records);
  }
  console.end_progress();
  if (!more) console.error(input.name() + ": " + more.error().message);
  if (more && records == 0) console.error(input.name() + ": holds no strokes");
  return true;
}

/// The same of a file that is read as a whole.
bool read_stored_pieces(const std::string& path, Format format, Console& console,
                        const std::function<bool(const SketchPiece&)>& take) {
  const Result<Sketch> sketch = read_stored_sketch(path);
  if (!sketch) {
    console.error(sketch.error().message);
    return false;
  }
  if (sketch->empty()) console.error(path + ": holds no strokes");
  SketchPiece piece;
  std::int64_t number = 0;
  for (const SketchStroke& stroke : *sketch) {
    const Result<void> added = encode(stroke, ++number, format, piece);
    if (!added) console.error(fmt::format("{}: {}: {}", path, stroke.id, added.error().message));
    if (piece.text.size() < kBatchBytes) continue;
    if (!take(piece)) return false;
    piece.clear();
  }
  return piece.text.empty() || take(piece);
}

}  // namespace

bool for_each_piece(const std::string& path, Format format, Console& console,
                    const std::function<bool(const SketchPiece&)>& take) {
  if (is_stored_sketch(path)) return read_stored_pieces(path, format, console, take);
  const Result<Input> input = Input::open(path);
  if (!input) {
    console.error(input_name(path) + ": " + input.error().message);
    return false;
  }
  return read_pieces(*input, format, console, take);
}

}  // namespace felt::cli
