#pragma once

#include <memory>

#include "felt/driver/byte_stream.h"
#include "felt/driver/driver.h"

namespace felt {

struct PantographOptions {
  /// How a port is opened; tests put a fake in its place.
  SerialOpen open = SerialStream::open;
  /// Where ports and FELT_PANTOGRAPH_PORT are looked for; must outlive the driver.
  const SystemView* system = &this_system();
};

/// Haply's 2DIY: a five-bar pantograph on Haply's board, by its serial protocol; nothing of the
/// maker is needed. It moves in a plane that is the drawing plane.
///
/// No board says which make it is: each port that may be one is listed once for each make. Ports of
/// Arduino-like boards are looked for; FELT_PANTOGRAPH_PORT ("/dev/ttyACM0" or "/dev/ttyACM0:v2")
/// names one, and with it the make.
///
/// The frame: x to the left as one sits before it, y towards the person, z up; the origin at the
/// axis of motor 1.
std::unique_ptr<Driver> make_pantograph_driver(PantographOptions options = {});

}  // namespace felt
