#include "felt/replay/option_text.h"

#include <charconv>

namespace felt {

Result<OptionValue> value_like(const OptionValue& present, const std::string& text) {
  if (std::holds_alternative<std::string>(present)) return OptionValue(text);
  if (std::holds_alternative<bool>(present)) {
    if (text == "on" || text == "true") return OptionValue(true);
    if (text == "off" || text == "false") return OptionValue(false);
    return fail(ErrorCode::kInvalidArgument, "'" + text + "' must be on or off");
  }
  double number = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size()) {
    return fail(ErrorCode::kInvalidArgument, "'" + text + "' is not a number");
  }
  return OptionValue(number);
}

Result<SetOption> option_event(const Session& session, const std::string& text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos) {
    return fail(ErrorCode::kInvalidArgument, "'" + text + "' is not TOOL.OPTION=VALUE");
  }
  const std::string id = text.substr(0, equals);
  const Result<OptionValue> present = session.option(id);
  if (!present) return tl::unexpected(present.error());
  const Result<OptionValue> value = value_like(*present, text.substr(equals + 1));
  if (!value) return fail(value.error().code, id + ": " + value.error().message);
  return SetOption{session.current_option_id(id), *value};
}

}  // namespace felt
