#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "felt/session/event.h"
#include "felt/tools/contact.h"

namespace felt {

/// Returns the options that had other defaults in an earlier version of the defaults, with those
/// defaults; empty for the current version. Version 1 is that of Feltline 0.1.0. A recording leaves
/// out options that have their default, so a recording with older defaults needs these values to
/// give the same drawing. The option pull.keep_offset did not exist in version 1; the pull tool
/// worked as if it were on.
///
/// If you change a default, increment kOptionDefaults and add the previous default here.
inline std::vector<SetOption> old_defaults(int version) {
  using namespace std::string_literals;
  std::vector<SetOption> old;
  if (version <= 1) {
    old = {{"pencil.reach_mm", 8.0},     {"pencil.snap_radius_mm", 2.0},
           {"pencil.attraction_n", 0.6}, {"pencil.keep_separate", false},
           {"pull.keep_offset", true},   {"eraser.include_width", false},
           {"lasso.take", "points"s}};
  }
  if (version <= 2) old.push_back({"pencil.strength", 1.0});
  if (version >= 3 && version <= 5) old.push_back({"pencil.strength", 0.5});
  if (version == 2 || version == 3) old.push_back({"lasso.take", "strokes"s});
  if (version <= 7) old.push_back({"pencil.retrace_n", 0.0});
  if (version <= 8) {
    for (const char* id : {"eraser.guard_n", "pull.yield_s"}) old.push_back({id, 0.0});
  }
  return old;
}

/// Returns the time on the surface after which a pen had landed (Contact::set_landed_ns) in this
/// version of the defaults.
inline std::int64_t landed_ns(int version) noexcept {
  if (version < 4) return 0;
  return version < 9 ? 120'000'000 : Contact::kLandedNs;
}

}  // namespace felt
