#pragma once

/// Reads one line of .ndjson as the members of a JSON object and checks them against a table of
/// keys. Private to this layer. The functions that read the values of the keys are in
/// ndjson_fields.h and event_fields.h.

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "felt/io/ndjson/ndjson_json.h"
#include "felt/io/ndjson/ndjson_lines.h"

namespace felt::json {

/// A key of a record, whether it is required, and the function that stores its value.
template <class Record>
struct Field {
  std::string_view key;
  bool required;
  Result<void> (*parse)(Value& value, Record& out);
};

/// Checks a value whose key is unknown. Errors start with the key.
Result<void> check_unknown(std::string_view key, Value& value);

/// Checks a line as far as that is possible before it is parsed as JSON.
Result<void> check_text(const NdjsonLine& line);

/// Tracks which fields of a record were present. At most 32 fields.
template <class Record>
class Fields {
 public:
  Fields(std::span<const Field<Record>> known, Record& out) : known_(known), out_(out) {}

  Result<void> take(std::string_view key, Value& value) {
    std::size_t i = 0;
    while (i < known_.size() && known_[i].key != key) ++i;
    if (i == known_.size()) return check_unknown(key, value);
    const std::uint32_t bit = std::uint32_t{1} << i;
    if (seen_ & bit) return bad("key \"" + std::string(key) + "\" occurs twice");
    seen_ |= bit;
    return known_[i].parse(value, out_);
  }

  /// Fails if a required key was missing.
  [[nodiscard]] Result<void> finish() const {
    for (std::size_t i = 0; i < known_.size(); ++i) {
      if (known_[i].required && !(seen_ >> i & 1)) {
        return bad("key \"" + std::string(known_[i].key) + "\" is missing");
      }
    }
    return {};
  }

 private:
  std::span<const Field<Record>> known_;
  Record& out_;
  std::uint32_t seen_ = 0;
};

/// Calls `take(key, value)`, which returns a Result<void>, for each member of the object in the
/// line, and checks that nothing follows the object in the line. `key` is valid until the next
/// string is read. If `take` does not read a value, the value is skipped without a check.
template <class Take>
Result<void> for_each_member(simdjson::ondemand::parser& parser, const NdjsonLine& line,
                             Take&& take) {
  if (Result<void> fine = check_text(line); !fine) return fine;
  const std::string_view text = line.text();
  const simdjson::padded_string_view padded(text, text.size() + kLinePadding);
  static_assert(kLinePadding >= simdjson::SIMDJSON_PADDING);
  simdjson::ondemand::document document;
  simdjson::ondemand::object object;
  if (const auto error = parser.iterate(padded).get(document)) {
    return tl::unexpected(syntax_error(error));
  }
  if (const auto error = document.get_object().get(object)) {
    return tl::unexpected(syntax_error(error));
  }
  for (auto member : object) {
    simdjson::ondemand::field field;
    std::string_view key;
    if (const auto error = std::move(member).get(field)) {
      return tl::unexpected(syntax_error(error));
    }
    if (const auto error = field.unescaped_key().get(key)) {
      return tl::unexpected(syntax_error(error));
    }
    if (Result<void> taken = take(key, field.value()); !taken) return taken;
  }
  if (!document.current_location().error()) return bad("there is text after the end of the object");
  return {};
}

}  // namespace felt::json
