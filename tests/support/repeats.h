#pragma once

#include <algorithm>

namespace felt {

/// True in a build with sanitizers. It is several times as slow, and looks for other errors than
/// wrong numbers.
#ifdef FELT_SANITIZED
inline constexpr bool kSanitized = true;
#else
inline constexpr bool kSanitized = false;
#endif

/// Returns how often a long test repeats its steps: `usual` times, or a tenth of it with
/// sanitizers.
constexpr int repeats(int usual) {
  return kSanitized ? std::max(1, usual / 10) : usual;
}

}  // namespace felt
