#pragma once

#include <cstdint>
#include <vector>

#include "felt/driver/byte_stream.h"
#include "felt/driver/diagnosis.h"

namespace felt::haply {

/// Implements Driver::diagnose: checks whether the service is installed and running, its ports and
/// version, and what it reports about its devices. If something listens, the service itself is
/// asked through `connect`.
std::vector<Finding> examine(const SystemView& system, const TcpConnect& connect,
                             std::int64_t within_ns);

}  // namespace felt::haply
