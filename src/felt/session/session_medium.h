#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "felt/session/event.h"
#include "felt/session/session.h"

namespace felt {

/// Returns the medium of the current tool: the eraser if the tool erases, the value of its option
/// "medium" if the tool has this option, and otherwise the pencil. The reference is valid as long
/// as the session's materials do not change.
const Medium& medium_in_hand(const Session& session);

/// Returns the full id of an option of the first tool that draws, for example "pencil.medium" for
/// "medium".
std::string drawing_option(const Session& session, std::string_view option);
/// Returns the id of the medium of new lines; "" if no tool draws.
std::string drawing_medium(const Session& session);
/// Returns the options to set so that new lines are drawn in this medium as intended: the medium
/// itself, its widths, and its pressure curve.
std::vector<SetOption> options_for_medium(const Session& session, const Medium& medium);

}  // namespace felt
