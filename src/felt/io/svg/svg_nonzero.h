#pragma once

#include <vector>

#include "felt/document/fill.h"

namespace felt {

/// Replaces loops that are filled by the non-zero rule and cross each other or themselves by loops
/// that cover the same area by the even-odd rule. Returns false, and leaves the loops unchanged, if
/// they have too many segments or if parts of them lie on each other.
bool resolve_crossings(std::vector<FillLoop>& loops);

}  // namespace felt
