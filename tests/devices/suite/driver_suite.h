#pragma once

#include <string>

#include "tests/devices/drivers/driver_bench.h"

namespace felt {

/// What the maker's axes become: where the hand goes, samples go, along each axis of the sheet (in
/// the plane alone on a planar device). Empty, or what is wrong.
std::string check_axes(const BenchMaker& make);

/// Where a force in the sheet's frame is felt: along the same axis, the same way, as strong; one
/// that lifts off the sheet moves the pen up, and so on. Empty, or what is wrong.
std::string check_force_signs(const BenchMaker& make);

/// A pen that presses into the sheet is pushed out by the loop with the sheet's own force (not on a
/// planar device, which cannot). Empty, or what is wrong.
std::string check_pressing(const BenchMaker& make);

/// What a driver says of itself: identity, capabilities no larger than its model's row, the status
/// of a healthy device. Empty, or what is wrong.
std::string check_words(const BenchMaker& make);

}  // namespace felt
