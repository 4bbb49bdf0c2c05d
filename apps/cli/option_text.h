#pragma once

#include <string>

#include "felt/base/result.h"
#include "felt/session/session.h"

namespace felt::cli {

/// An option's value as text, read as the kind of value that it has now ("on" for one that is true
/// or false). Error: it is none.
Result<OptionValue> value_like(const OptionValue& present, const std::string& text);

/// The event of "--set TOOL.OPTION=VALUE". Error: no such option, or no such value.
Result<SetOption> option_event(const Session& session, const std::string& text);

}  // namespace felt::cli
