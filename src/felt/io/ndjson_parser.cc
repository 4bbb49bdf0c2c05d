#include "felt/io/ndjson_parser.h"

#include <array>
#include <utility>

#include "felt/io/ndjson_fields.h"

namespace felt {
namespace {

using json::bad;
using json::Value;

/// Above this a buffer that one huge line needed is given back after it.
constexpr std::size_t kKeptBytes = std::size_t{16} << 20;

/// A key that the record knows, whether it must be there, and where its value goes.
template <class Record>
struct Field {
  std::string_view key;
  bool required;
  Result<void> (*parse)(Value& value, Record& out);
};

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

/// Which fields of a record have had their key.
template <class Record, std::size_t N>
class Fields {
 public:
  Fields(const std::array<Field<Record>, N>& known, Record& out) : known_(known), out_(out) {}

  Result<void> take(std::string_view key, Value& value) {
    std::size_t i = 0;
    while (i < N && known_[i].key != key) ++i;
    if (i == N) return take_ignored(key, value);
    if (std::exchange(seen_[i], true)) {
      return bad("key \"" + std::string(key) + "\" occurs twice");
    }
    return known_[i].parse(value, out_);
  }

  /// Fails when a required key never came.
  [[nodiscard]] Result<void> finish() const {
    for (std::size_t i = 0; i < N; ++i) {
      if (known_[i].required && !seen_[i]) {
        return bad("key \"" + std::string(known_[i].key) + "\" is missing");
      }
    }
    return {};
  }

 private:
  static Result<void> take_ignored(std::string_view key, Value& value) {
    const std::string name = json::excerpt(key);  // the text of the key goes with the next string
    Result<void> checked = json::check_ignored(value);
    if (!checked) return tl::unexpected(with_context(checked.error(), name));
    return checked;
  }

  const std::array<Field<Record>, N>& known_;
  Record& out_;
  std::array<bool, N> seen_{};
};

/// What can be said against a line before looking at it as JSON.
Result<void> check_text(const NdjsonLine& line) {
  if (line.too_long()) {
    return fail(
        ErrorCode::kLimitExceeded,
        "the line is longer than " + std::to_string(limits::kMaxLineBytes >> 20) + " MiB; skipped");
  }
  const std::size_t nul = line.text().find('\0');
  if (nul != std::string_view::npos) return bad("byte " + std::to_string(nul + 1) + " is NUL");
  const std::size_t start = line.text().find_first_not_of(" \t\r");
  if (start == std::string_view::npos || line.text()[start] != '{') {
    return bad("not a JSON object, which starts with {");
  }
  return {};
}

}  // namespace

struct NdjsonParser::State {
  simdjson::ondemand::parser parser;

  template <class Record, std::size_t N>
  Result<NdjsonKind> parse(const NdjsonLine& line, const std::array<Field<Record>, N>& known,
                           Record& out);
};

template <class Record, std::size_t N>
Result<NdjsonKind> NdjsonParser::State::parse(const NdjsonLine& line,
                                              const std::array<Field<Record>, N>& known,
                                              Record& out) {
  if (Result<void> fine = check_text(line); !fine) return tl::unexpected(fine.error());
  const std::string_view text = line.text();
  const simdjson::padded_string_view padded(text, text.size() + kLinePadding);
  static_assert(kLinePadding >= simdjson::SIMDJSON_PADDING);
  simdjson::ondemand::document document;
  simdjson::ondemand::object object;
  if (const auto error = parser.iterate(padded).get(document)) {
    return tl::unexpected(json::syntax_error(error));
  }
  if (const auto error = document.get_object().get(object)) {
    return tl::unexpected(json::syntax_error(error));
  }
  HeaderRecord header;
  Fields header_fields(kHeaderFields, header);
  Fields fields(known, out);
  bool first = true, is_header = false;
  for (auto member : object) {
    simdjson::ondemand::field field;
    std::string_view key;
    if (const auto error = std::move(member).get(field)) {
      return tl::unexpected(json::syntax_error(error));
    }
    if (const auto error = field.unescaped_key().get(key)) {
      return tl::unexpected(json::syntax_error(error));
    }
    if (std::exchange(first, false)) is_header = key == kHeaderFields[0].key;
    Result<void> taken =
        is_header ? header_fields.take(key, field.value()) : fields.take(key, field.value());
    if (!taken) return tl::unexpected(taken.error());
  }
  if (!document.current_location().error()) return bad("text goes on after the end of the object");
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
  Result<NdjsonKind> kind = state_->parse(line, kRawFields, out);
  release_large_buffers();
  return kind;
}

Result<NdjsonKind> NdjsonParser::sketch_stroke(const NdjsonLine& line, SketchRecord& out) {
  out = {};
  Result<NdjsonKind> kind = state_->parse(line, kSketchFields, out);
  release_large_buffers();
  return kind;
}

void NdjsonParser::release_large_buffers() {
  if (state_->parser.capacity() > kKeptBytes) state_ = std::make_unique<State>();
}

}  // namespace felt
