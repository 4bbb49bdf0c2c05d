#include "felt/io/ndjson_parser.h"

#include <array>
#include <utility>

#include "felt/io/ndjson_fields.h"
#include "felt/io/ndjson_object.h"

namespace felt {
namespace {

using json::Field;
using json::Fields;
using json::Value;

/// Above this a buffer that one huge line needed is given back after it.
constexpr std::size_t kKeptBytes = std::size_t{16} << 20;

constexpr std::array kRawFields = {
    Field<RawStroke>{"id", false, [](Value& v, RawStroke& r) { return json::parse_id(v, r.id); }},
    Field<RawStroke>{"points", true,
                     [](Value& v, RawStroke& r) { return json::parse_points(v, r.samples); }},
};

using SketchField = Field<SketchRecord>;
constexpr std::array kSketchFields = {
    SketchField{"id", false, [](Value& v, SketchRecord& r) { return json::parse_id(v, r.id); }},
    SketchField{"closed", false,
                [](Value& v, SketchRecord& r) { return json::parse_closed(v, r.data.closed); }},
    SketchField{"segments", true,
                [](Value& v, SketchRecord& r) { return json::parse_segments(v, r.data.points); }},
    SketchField{"joints", true,
                [](Value& v, SketchRecord& r) { return json::parse_joints(v, r.data.joints); }},
    SketchField{"widths", true,
                [](Value& v, SketchRecord& r) { return json::parse_widths(v, r.data.widths); }},
    SketchField{"material", false,
                [](Value& v, SketchRecord& r) { return json::parse_material(v, r.data.material); }},
    SketchField{"color", false,
                [](Value& v, SketchRecord& r) { return json::parse_color(v, r.data.color); }},
};

/// A header stores nothing; what it says must be what we know.
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
  out = {};
  Result<NdjsonKind> kind = state_->parse<SketchRecord>(line, kSketchFields, out);
  release_large_buffers();
  return kind;
}

void NdjsonParser::release_large_buffers() {
  if (state_->parser.capacity() > kKeptBytes) state_ = std::make_unique<State>();
}

}  // namespace felt
