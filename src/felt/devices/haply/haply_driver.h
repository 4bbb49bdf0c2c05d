#pragma once

#include <memory>

#include "felt/driver/byte_stream.h"
#include "felt/driver/driver.h"

namespace felt {

struct HaplyOptions {
  /// How the service is reached; tests put a fake in its place.
  TcpConnect connect = TcpStream::connect;
  /// Where FELT_HAPLY_URL and the service's own configuration are looked for; must outlive the
  /// driver.
  const SystemView* system = &this_system();
  /// For the key and the masks of the WebSocket; 0: from the system's randomness.
  std::uint64_t seed = 0;
};

/// Haply's Inverse3, Inverse3x and Minverse, through Haply's own Inverse Service 3.x, which must
/// run on this machine: JSON over a WebSocket (haply/README.md). The service is looked for at
/// FELT_HAPLY_URL ("ws://localhost:10001"), or at the ports of its own configuration file; its
/// events at FELT_HAPLY_EVENTS_URL, or likewise.
///
/// The frame is the service's own with the origin in the middle of the workspace: x right, y away
/// from the person, z up, right-handed.
std::unique_ptr<Driver> make_haply_driver(HaplyOptions options = {});

}  // namespace felt
