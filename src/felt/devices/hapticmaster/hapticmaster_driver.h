#pragma once

#include <memory>

#include "felt/driver/byte_stream.h"
#include "felt/driver/driver.h"

namespace felt {

struct HapticMasterOptions {
  /// Connects to the controller; tests pass a fake.
  TcpConnect connect = TcpStream::connect;
  /// The system in which to read FELT_HAPTICMASTER_ADDRESS. It must outlive the driver.
  const SystemView* system = &this_system();
};

/// Makes the driver of the HapticMASTER (FCS, later Moog), which uses the text protocol of its
/// controller (hapticmaster/README.md). The controller is never looked for: its address is in
/// FELT_HAPTICMASTER_ADDRESS ("192.168.0.25" or "192.168.0.25:7654"), and without it there is no
/// device.
///
/// Positions are in the machine's own frame: x from its axis towards the user, y to the user's
/// right, z up, right-handed.
std::unique_ptr<Driver> make_hapticmaster_driver(HapticMasterOptions options = {});

}  // namespace felt
