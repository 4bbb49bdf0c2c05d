#pragma once

#include <cstdint>
#include <vector>

#include "felt/driver/byte_stream.h"
#include "felt/driver/diagnosis.h"

namespace felt::haply {

/// Implements Driver::diagnose: checks whether the service is installed and running, which ports
/// and version it has, and what it reports about its devices. If a program listens on the service's
/// port, the function connects to that program through `connect` and queries it.
std::vector<Finding> examine(const SystemView& system, const TcpConnect& connect,
                             std::int64_t within_ns);

}  // namespace felt::haply
