#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "felt/base/result.h"

namespace felt::bench {

/// Simulated people of all models erase the part of a line between two other lines that cross it,
/// with neighbours beside it, without and with the force that keeps the eraser away from other
/// lines (`eraser.guard_n`). Prints the changes for these devices. Returns false if a bar is
/// missed.
Result<bool> compare_erasing(const std::vector<std::string>& devices, std::size_t people);

}  // namespace felt::bench
