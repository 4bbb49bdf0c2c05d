#pragma once

#include <vector>

#include "felt/document/fill.h"

namespace felt {

/// Replaces loops that are filled by the non-zero rule by loops that cover the same area by the
/// even-odd rule, within 0.005 mm. Loops may cross, touch, and lie on each other or on themselves.
/// Curves stay curves. Loops that already cover the same area by both rules stay as they are, bit
/// for bit; no loop is left if the area is empty. Returns false, and leaves the loops unchanged, if
/// the work exceeds a limit.
bool make_even_odd(std::vector<FillLoop>& loops);

}  // namespace felt
