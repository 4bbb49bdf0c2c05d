#pragma once

#include <memory>

#include "felt/driver/byte_stream.h"
#include "felt/driver/driver.h"

namespace felt {

struct HaplyOptions {
  /// Connects to the service; tests pass a fake.
  TcpConnect connect = TcpStream::connect;
  /// The system in which to read FELT_HAPLY_URL and the service's configuration file. It must
  /// outlive the driver.
  const SystemView* system = &this_system();
  /// Seed for the key and the masks of the WebSocket. If 0, the system's random numbers are used.
  std::uint64_t seed = 0;
};

/// Makes the driver of Haply's Inverse3, Inverse3x and Minverse, which uses Haply's own Inverse
/// Service 3.x on this machine: JSON over a WebSocket (haply/README.md). The service's address
/// comes from FELT_HAPLY_URL ("ws://localhost:10001") or from the service's configuration file. The
/// address of its events comes from FELT_HAPLY_EVENTS_URL or from the same file.
///
/// Positions are in the service's own frame with the origin in the centre of the workspace: x
/// right, y away from the user, z up, right-handed.
std::unique_ptr<Driver> make_haply_driver(HaplyOptions options = {});

}  // namespace felt
