#pragma once

#include <string>

#include "felt/base/result.h"
#include "felt/session/session.h"

namespace felt {

/// Parses text as a value of the same kind as `present`, the current value of the option. A boolean
/// value is "on", "off", "true" or "false". Fails if the text is not a value of that kind.
Result<OptionValue> value_like(const OptionValue& present, const std::string& text);

/// Returns the event for "TOOL.OPTION=VALUE". Fails if the text has no "=", the option does not
/// exist, or the value is not of the option's kind.
Result<SetOption> option_event(const Session& session, const std::string& text);

}  // namespace felt
