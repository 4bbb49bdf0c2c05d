#pragma once

#include <cstdint>

#include "felt/session/session.h"

namespace felt::desktop {

/// Selects the tool of `from` in `to` and copies the options. Requires that all options of `to`
/// have their defaults. If `to` refuses an option (for example a material that only the drawing of
/// `from` has), the option keeps its default.
void copy_options(const Session& from, Session& to, std::int64_t now_ns);

}  // namespace felt::desktop
