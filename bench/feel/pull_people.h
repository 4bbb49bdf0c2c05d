#pragma once

#include <cstddef>
#include <string>
#include <string_view>
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

/// Levels of pull.strength: the plane of the surface alone, and the default.
inline constexpr std::string_view kPlaneOnlyPull, kDefaultPull = "1";

/// Lets people pull a line to 12 goals and rest there. Returns the means.
Result<Pulled> pull_lines(const StylusPreset& device, const std::vector<Person>& people,
                          std::string_view strength, double rest_s);

/// Simulated people of all models pull a line by its middle to a given point, rest there, and lift
/// the pen, with the plane only and at several levels of the option pull.strength. Prints how far
/// the line is from that point afterwards, and how far the pen went beyond it. Returns false if a
/// bar is missed.
Result<bool> compare_pulls(const std::vector<std::string>& devices, std::size_t people);

}  // namespace felt::bench
