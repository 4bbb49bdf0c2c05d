#pragma once

#include <memory>

#include "felt/driver/byte_stream.h"
#include "felt/driver/driver.h"

namespace felt {

struct HaplyOptions {
  /// Connects to the service; tests pass a fake.
  TcpConnect connect = TcpStream::connect;
  /// Gives FELT_HAPLY_URL and the service's own configuration; must outlive the driver.
  const SystemView* system = &this_system();
  /// For the key and the masks of the WebSocket; 0: the system's randomness.
  std::uint64_t seed = 0;
};

/// Makes the driver of Haply's Inverse3, Inverse3x and Minverse, which uses Haply's own Inverse
/// Service 3.x on this machine: JSON over a WebSocket (haply/README.md). The service's address is
/// FELT_HAPLY_URL ("ws://localhost:10001"), or has the ports of its own configuration file; the
/// address of its events is FELT_HAPLY_EVENTS_URL, or found in the same way.
///
/// The frame is the service's own with the origin in the centre of the workspace: x right, y away
/// from the user, z up, right-handed.
std::unique_ptr<Driver> make_haply_driver(HaplyOptions options = {});

}  // namespace felt
