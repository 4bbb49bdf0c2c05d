#include "felt/io/ndjson/ndjson_object.h"

namespace felt::json {

Result<void> check_unknown(std::string_view key, Value& value) {
  const std::string name = excerpt(key);  // copied, because the next string overwrites the key
  Result<void> checked = check_ignored(value);
  if (!checked) return tl::unexpected(with_context(checked.error(), name));
  return checked;
}

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

}  // namespace felt::json
