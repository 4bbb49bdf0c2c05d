#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "felt/base/result.h"

namespace felt::bench {

/// Simulated people of all models draw over lines, without and with the force that holds them to
/// the line (`pencil.retrace_n`), and draw the first lines of pages, hatchings among them, in which
/// no line should hold them. Prints the changes for these devices. Returns false if a bar is
/// missed.
Result<bool> compare_retracing(const std::vector<std::string>& devices, std::size_t people);

}  // namespace felt::bench
