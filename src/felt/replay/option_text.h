#pragma once

#include <string>

#include "felt/base/result.h"
#include "felt/session/session.h"

namespace felt {

/// Reads text as the kind of value that an option has now ("on" for a boolean one). Fails if it is
/// no such value.
Result<OptionValue> value_like(const OptionValue& present, const std::string& text);

/// Returns the event of "TOOL.OPTION=VALUE". Fails if there is no such option or value.
Result<SetOption> option_event(const Session& session, const std::string& text);

}  // namespace felt
