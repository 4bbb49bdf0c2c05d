#pragma once

#include <string>

#include "felt/base/result.h"
#include "felt/session/session.h"

namespace felt {

/// Parses text as the same kind of value as the option has now ("on" for a boolean one). Fails if
/// the text is not such a value.
Result<OptionValue> value_like(const OptionValue& present, const std::string& text);

/// Returns the event for "TOOL.OPTION=VALUE". Fails if the text has no "=", the option does not
/// exist, or the value is not of its kind.
Result<SetOption> option_event(const Session& session, const std::string& text);

}  // namespace felt
