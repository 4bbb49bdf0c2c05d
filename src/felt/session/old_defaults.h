#pragma once

#include <string>
#include <vector>

#include "felt/session/event.h"

namespace felt {

/// Returns the options whose defaults were different in Feltline 0.1.0, with the defaults of that
/// version. A recording leaves out options that have their default, so a recording from that
/// version needs these defaults to give the same drawing. The option pull.keep_offset did not exist
/// in that version; the pull tool worked as if it were on.
///
/// If you change a default, increment kOptionDefaults and add a list of the previous defaults.
inline std::vector<SetOption> defaults_of_version_1() {
  using namespace std::string_literals;
  return {{"pencil.reach_mm", 8.0},     {"pencil.snap_radius_mm", 2.0},
          {"pencil.attraction_n", 0.6}, {"pencil.keep_separate", false},
          {"pull.keep_offset", true},   {"eraser.include_width", false},
          {"lasso.take", "points"s}};
}

}  // namespace felt
