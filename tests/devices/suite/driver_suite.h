#pragma once

#include <string>

#include "tests/devices/drivers/driver_bench.h"

namespace felt {

// Each function checks one property of a bench's driver. It returns an empty string if the driver
// is correct, otherwise a description of the error.

/// Checks that the vendor's axes are converted correctly: samples follow the hand along each axis
/// of the surface. On a planar device only x and y are checked.
std::string check_axes(const BenchMaker& make);

/// Checks that the motors render a force in the frame of the surface along the same axis, in the
/// same direction and with the same strength. For example, a force in +z moves the pen up.
std::string check_force_signs(const BenchMaker& make);

/// Checks that the haptic loop pushes a pen out of the surface if the pen presses into it. Does
/// nothing for a planar device.
std::string check_pressing(const BenchMaker& make);

/// Checks the data that a driver reports: the identity of the device, forces within the row of its
/// model, and the status of a healthy device.
std::string check_words(const BenchMaker& make);

}  // namespace felt
