#pragma once

#include <memory>

#include "felt/driver/byte_stream.h"
#include "felt/driver/driver.h"

namespace felt {

struct HaplyOptions {
  /// Connects to the service; tests pass a fake.
  TcpConnect connect = TcpStream::connect;
  /// Provides FELT_HAPLY_URL and the service's own configuration; must outlive the driver.
  const SystemView* system = &this_system();
  /// Seeds the key and the masks of the WebSocket; 0 uses the system's random numbers.
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
