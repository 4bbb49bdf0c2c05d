#pragma once

#include <cstdint>

#include "felt/session/session.h"

namespace felt::desktop {

/// The values that differ, and the tool, told to a session that starts with the defaults. What it
/// does not take (a material that only the other drawing had) stays at its default.
void copy_options(const Session& from, Session& to, std::int64_t now_ns);

}  // namespace felt::desktop
