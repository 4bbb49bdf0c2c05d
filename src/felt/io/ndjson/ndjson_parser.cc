#include "felt/io/ndjson/ndjson_parser.h"

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "felt/io/ndjson/ndjson_fields.h"
#include "felt/io/ndjson/ndjson_object.h"

namespace felt {
namespace {

using json::Field;
using json::Fields;
using json::Value;

/// A buffer that grew beyond this for one huge line is freed after the line.
constexpr std::size_t kKeptBytes = std::size_t{16} << 20;

constexpr std::array kRawFields = {
    Field<RawStroke>{"id", false, [](Value& v, RawStroke& r) { return json::parse_id(v, r.id); }},
    Field<RawStroke>{"points", true,
                     [](Value& v, RawStroke& r) { return json::parse_points(v, r.samples); }},
};

/// A sketch line while it is parsed. The tones are stored separately until the line is complete,
/// because the widths, to which they belong, may come later.
struct SketchLine {
  SketchRecord record;
  std::optional<std::vector<double>> tones;

  Result<void> join() {
    if (!tones) return {};
    std::vector<WidthKnot>& knots = record.data.widths;
    if (tones->size() != knots.size()) {
      return json::bad("tones: " + std::to_string(tones->size()) + " for " +
                       std::to_string(knots.size()) + " widths");
    }
    for (std::size_t i = 0; i < knots.size(); ++i) knots[i].tone = (*tones)[i];
    return {};
  }
};

using SketchField = Field<SketchLine>;
constexpr std::array kSketchFields = {
    SketchField{"id", false,
                [](Value& v, SketchLine& s) { return json::parse_id(v, s.record.id); }},
    SketchField{
        "closed", false,
        [](Value& v, SketchLine& s) { return json::parse_closed(v, s.record.data.closed); }},
    SketchField{
        "segments", true,
        [](Value& v, SketchLine& s) { return json::parse_segments(v, s.record.data.points); }},
    SketchField{
        "joints", true,
        [](Value& v, SketchLine& s) { return json::parse_joints(v, s.record.data.joints); }},
    SketchField{
        "widths", true,
        [](Value& v, SketchLine& s) { return json::parse_widths(v, s.record.data.widths); }},
    SketchField{"tones", false,
                [](Value& v, SketchLine& s) { return json::parse_tones(v, s.tones.emplace()); }},
    SketchField{
        "material", false,
        [](Value& v, SketchLine& s) { return json::parse_material(v, s.record.data.medium); }},
    SketchField{"color", false,
                [](Value& v, SketchLine& s) { return json::parse_color(v, s.record.data.color); }},
};

/// A header stores nothing; its values are only checked against the ones we support.
struct HeaderRecord {};
constexpr std::array kHeaderFields = {
    Field<HeaderRecord>{"feltline", true,
                        [](Value& v, HeaderRecord&) { return json::parse_version(v); }},
    Field<HeaderRecord>{"unit", false, [](Value& v, HeaderRecord&) { return json::parse_unit(v); }},
};

}  // namespace

struct NdjsonParser::State {
  simdjson::ondemand::parser parser;

  template <class Record>
  Result<NdjsonKind> parse(const NdjsonLine& line, std::span<const Field<Record>> known,
                           Record& out);
};

template <class Record>
Result<NdjsonKind> NdjsonParser::State::parse(const NdjsonLine& line,
                                              std::span<const Field<Record>> known, Record& out) {
  HeaderRecord header;
  Fields<HeaderRecord> header_fields(kHeaderFields, header);
  Fields<Record> fields(known, out);
  bool first = true, is_header = false;
  const auto take = [&](std::string_view key, Value value) {
    if (std::exchange(first, false)) is_header = key == kHeaderFields[0].key;
    return is_header ? header_fields.take(key, value) : fields.take(key, value);
  };
  if (Result<void> walked = json::for_each_member(parser, line, take); !walked) {
    return tl::unexpected(walked.error());
  }
  if (Result<void> done = is_header ? header_fields.finish() : fields.finish(); !done) {
    return tl::unexpected(done.error());
  }
  return is_header ? NdjsonKind::kHeader : NdjsonKind::kStroke;
}

NdjsonParser::NdjsonParser() : state_(std::make_unique<State>()) {}
NdjsonParser::~NdjsonParser() = default;
NdjsonParser::NdjsonParser(NdjsonParser&&) noexcept = default;
NdjsonParser& NdjsonParser::operator=(NdjsonParser&&) noexcept = default;

Result<NdjsonKind> NdjsonParser::raw_stroke(const NdjsonLine& line, RawStroke& out) {
  out.id.clear();
  out.samples.clear();
  Result<NdjsonKind> kind = state_->parse<RawStroke>(line, kRawFields, out);
  release_large_buffers();
  return kind;
}

Result<NdjsonKind> NdjsonParser::sketch_stroke(const NdjsonLine& line, SketchRecord& out) {
  SketchLine sketch;
  Result<NdjsonKind> kind = state_->parse<SketchLine>(line, kSketchFields, sketch);
  release_large_buffers();
  if (kind && *kind == NdjsonKind::kStroke) {
    if (Result<void> joined = sketch.join(); !joined) return tl::unexpected(joined.error());
  }
  out = std::move(sketch.record);
  return kind;
}

void NdjsonParser::release_large_buffers() {
  if (state_->parser.capacity() > kKeptBytes) state_ = std::make_unique<State>();
}

}  // namespace felt
