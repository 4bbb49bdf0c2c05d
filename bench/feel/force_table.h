#pragma once

#include <cstddef>
#include <string>

#include "felt/base/result.h"

namespace felt::bench {

/// Prints a Markdown table with a row for each force: the error that it should reduce, the task and
/// its measure, what is published about people, how the force changes the measure for simulated
/// people of each model with this device, and the default. A change counts as a result only if its
/// sign is the same in all models.
Result<void> print_force_table(const std::string& device, std::size_t people);

}  // namespace felt::bench
