/// Reads any bytes as an .ndjson file. The reader must not crash. Accepted strokes must keep the
/// reader's documented guarantees, and must be unchanged after writing and reading them.

#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>

#include "felt/base/check.h"
#include "felt/io/ndjson/ndjson_parser.h"
#include "felt/io/ndjson/ndjson_writer.h"

namespace felt {
namespace {

/// Largest time that the file holds exactly. The file stores milliseconds as a double, which has
/// too few bits for larger times.
constexpr double kExactTimeNs = 2e15;

LineBatch batch_of(std::string_view text) {
  LineReader reader(read_text(text));
  LineBatch batch;
  FELT_CHECK(reader.fill(batch, text.size()).value_or(false));
  return batch;
}

void check_sample(const InkSample& sample) {
  FELT_CHECK(std::fabs(sample.position.x) <= limits::kMaxCoordinate);
  FELT_CHECK(std::fabs(sample.position.y) <= limits::kMaxCoordinate);
  FELT_CHECK(!sample.tilt_deg || (*sample.tilt_deg >= 0.0 && *sample.tilt_deg <= 90.0));
  FELT_CHECK(!sample.pressure || std::isfinite(*sample.pressure));
}

bool has_exact_times(const RawStroke& stroke) {
  for (const InkSample& sample : stroke.samples) {
    if (std::fabs(static_cast<double>(sample.time_ns.value_or(0))) > kExactTimeNs) return false;
  }
  return true;
}

void check_raw(NdjsonParser& parser, const NdjsonLine& line) {
  RawStroke first, second;
  if (parser.raw_stroke(line, first) != NdjsonKind::kStroke) return;
  FELT_CHECK(!first.samples.empty());
  for (const InkSample& sample : first.samples) check_sample(sample);
  std::string text;
  append_raw_line(text, first.id, first.samples);
  FELT_CHECK(parser.raw_stroke(batch_of(text).line(0), second) == NdjsonKind::kStroke);
  FELT_CHECK(first == second || !has_exact_times(first));
}

void check_sketch(NdjsonParser& parser, const NdjsonLine& line) {
  SketchRecord first, second;
  if (parser.sketch_stroke(line, first) != NdjsonKind::kStroke) return;
  std::string text, again;
  append_sketch_line(text, first.id, first.data);
  const LineBatch batch = batch_of(text);
  FELT_CHECK(parser.sketch_stroke(batch.line(0), second) == NdjsonKind::kStroke);
  FELT_CHECK(first == second);
  append_sketch_line(again, second.id, second.data);
  FELT_CHECK(text == again);
  const Result<Stroke> stroke = Stroke::create(first.data);
  FELT_CHECK(stroke.has_value() == check_invariants(first.data).has_value());
}

}  // namespace
}  // namespace felt

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace felt;
  constexpr std::size_t kMaxLine = 2000;  // small, so that inputs of the fuzzer exceed it
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  LineReader reader(read_text(text), kMaxLine);
  LineBatch batch;
  NdjsonParser parser;
  while (reader.fill(batch, 512).value_or(false)) {
    for (std::size_t i = 0; i < batch.size(); ++i) {
      FELT_CHECK(batch.line(i).text().size() <= kMaxLine);
      check_raw(parser, batch.line(i));
      check_sketch(parser, batch.line(i));
    }
  }
  return 0;
}
