#pragma once

#include <cstdint>
#include <vector>

#include "felt/driver/byte_stream.h"
#include "felt/driver/diagnosis.h"

namespace felt::haply {

/// Driver::diagnose: is the service installed, does it run, on which ports, how old is it, and what
/// does it say of its devices? The service itself is asked over `connect`, when somebody listens.
std::vector<Finding> examine(const SystemView& system, const TcpConnect& connect,
                             std::int64_t within_ns);

}  // namespace felt::haply
