#pragma once

#include <memory>

#include "felt/driver/byte_stream.h"
#include "felt/driver/driver.h"

namespace felt {

struct PantographOptions {
  /// Opens a serial port; tests pass a fake.
  SerialOpen open = SerialStream::open;
  /// The system in which to look for ports and FELT_PANTOGRAPH_PORT. It must outlive the driver.
  const SystemView* system = &this_system();
};

/// Makes the driver of Haply's 2DIY: a five-bar pantograph on Haply's board. The driver uses the
/// board's serial protocol and needs no software of the maker. The device's plane of motion is the
/// drawing plane.
///
/// A board does not report its version, so each port that may be a board is listed once for each
/// version. Ports of Arduino-like boards are found automatically; FELT_PANTOGRAPH_PORT
/// ("/dev/ttyACM0" or "/dev/ttyACM0:v2") names a port, and optionally its version.
///
/// The frame of the device, as seen by the user, has x to the left, y towards the user, z up, with
/// the origin at the axis of motor 1.
std::unique_ptr<Driver> make_pantograph_driver(PantographOptions options = {});

}  // namespace felt
