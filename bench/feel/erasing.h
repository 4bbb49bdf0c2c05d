#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "felt/base/result.h"
#include "felt/devices/simulated/person.h"
#include "felt/devices/simulated/stylus_presets.h"

namespace felt::bench {

/// What one person erased, per trial.
struct Erased {
  double extra_mm = 0.0;  // of ink that was not meant
  double wrong = 0.0;     // lines that were not meant and have lost ink
  double left_mm = 0.0;   // of ink that was meant
  double seconds = 0.0;   // from the touch to the lift
  double mean_n = 0.0, max_n = 0.0;
};

/// Lets a person erase in 12 trials, with the default options, or without the force.
Result<Erased> erase_all(const Person& person, const StylusPreset& device, bool is_on);

/// Simulated people of all models erase the part of a line between two other lines that cross it,
/// with neighbours beside it, without and with the force that keeps the eraser away from other
/// lines (`eraser.guard_n`). Prints the changes for these devices. Returns false if a bar is
/// missed.
Result<bool> compare_erasing(const std::vector<std::string>& devices, std::size_t people);

}  // namespace felt::bench
