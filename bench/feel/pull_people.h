#pragma once

#include <cstddef>
#include <string>

#include "felt/base/result.h"

namespace felt::bench {

/// Simulated people pull a line by its middle to a given point, with forces off and at several
/// levels of the option pull.strength. Prints how far the line is from that point afterwards, and
/// how the forces change this for each person.
Result<void> compare_pulls(const std::string& device, std::size_t people);

}  // namespace felt::bench
