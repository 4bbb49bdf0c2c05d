#include "sketch_input.h"

#include <fmt/core.h>

#include "felt/io/ndjson_parser.h"
#include "format.h"

namespace felt::cli {
namespace {

constexpr std::size_t kBatchBytes = std::size_t{64} << 10;

/// One line as a stroke; nothing for a header.
Result<std::optional<SketchStroke>> read_stroke(NdjsonParser& parser, const NdjsonLine& line,
                                                std::int64_t record_number) {
  SketchRecord record;
  const Result<NdjsonKind> kind = parser.sketch_stroke(line, record);
  if (!kind) return tl::unexpected(kind.error());
  if (*kind == NdjsonKind::kHeader) return std::nullopt;
  Result<Stroke> stroke = Stroke::create(std::move(record.data));
  if (!stroke) return tl::unexpected(stroke.error());
  if (record.id.empty()) record.id = fmt::format("s{}", record_number);
  return SketchStroke{std::move(record.id), *std::move(stroke)};
}

Result<void> check_readable(const std::string& path) {
  const Result<Format> format = format_of_path(path);
  if (!format) return tl::unexpected(format.error());
  if (*format == Format::kNdjson) return {};
  return fail(ErrorCode::kUnsupported, path + ": sketches are read from .ndjson only, so far");
}

}  // namespace

bool for_each_stroke(const std::string& path, Console& console,
                     const std::function<bool(const SketchStroke&)>& take) {
  if (const Result<void> readable = check_readable(path); !readable) {
    console.error(readable.error().message);
    return false;
  }
  const Result<Input> input = Input::open(path);
  if (!input) {
    console.error(input_name(path) + ": " + input.error().message);
    return false;
  }
  LineReader reader(input->reader());
  LineBatch batch;
  NdjsonParser parser;
  std::int64_t records = 0;
  for (;;) {
    const Result<bool> more = reader.fill(batch, kBatchBytes);
    if (!more) console.error(input->name() + ": " + more.error().message);
    if (!more || !*more) break;
    for (std::size_t i = 0; i < batch.size(); ++i) {
      const NdjsonLine line = batch.line(i);
      Result<std::optional<SketchStroke>> stroke = read_stroke(parser, line, ++records);
      if (!stroke) {
        console.error(
            fmt::format("{}:{}: {}", input->name(), line.number(), stroke.error().message));
      } else if (*stroke && !take(**stroke)) {
        return false;
      }
    }
    console.progress("reading", reader.bytes_read(), input->size_bytes(), records);
  }
  console.end_progress();
  if (records == 0) console.error(input->name() + ": holds no strokes");
  return true;
}

}  // namespace felt::cli
