#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "felt/base/result.h"
#include "felt/devices/simulated/person.h"
#include "felt/devices/simulated/stylus_presets.h"

namespace felt::bench {

/// What a person did, per pull.
struct Pulled {
  double final_mm = 0.0;      ///< from the line to the goal, after the lift
  double overshoot_mm = 0.0;  ///< how far the pen went beyond the goal
};

/// Options of a session: ids and values.
using PullOptions = std::vector<std::pair<std::string, std::string>>;

/// Returns the options with which people feel the plane of the surface alone.
PullOptions plane_only_pull();

/// Lets people pull a line to 12 goals and rest there. Returns the means.
Result<Pulled> pull_lines(const StylusPreset& device, const std::vector<Person>& people,
                          const PullOptions& options, double rest_s);

/// Simulated people of all models pull a line by its middle to a given point, rest there, and lift
/// the pen: with the plane only, with the counter-force of the paper, which does not yield, and
/// with the default options and `options`. Prints how far the line is from that point afterwards,
/// and how far the pen went beyond it. Returns false if a bar is missed with the last of these.
Result<bool> compare_pulls(const std::vector<std::string>& devices, std::size_t people,
                           const PullOptions& options);

}  // namespace felt::bench
