#pragma once

#include <cstdint>

#include "felt/session/session.h"

namespace felt::desktop {

/// Applies the tool and the options of `from` to `to`, a session that has the defaults. If `to`
/// refuses an option (for example a material that only the other drawing had), the option keeps
/// its default.
void copy_options(const Session& from, Session& to, std::int64_t now_ns);

}  // namespace felt::desktop
