#pragma once

#include <optional>
#include <string>
#include <vector>

#include "felt/driver/byte_stream.h"
#include "felt/driver/diagnosis.h"
#include "felt/driver/net_address.h"

namespace felt::hapticmaster {

inline constexpr const char* kAddressVariable = "FELT_HAPTICMASTER_ADDRESS";
/// The port that a public client uses. It is not known whether all controllers have it.
inline constexpr std::uint16_t kUsualPort = 7654;

/// Returns the address in FELT_HAPTICMASTER_ADDRESS, or nullopt if the variable is not set or not
/// an address.
std::optional<NetAddress> controller_address(const SystemView& system);

/// Implements Driver::diagnose: checks the address, and asks a controller that is there for its
/// state through `connect`. Nothing moves.
std::vector<Finding> examine(const SystemView& system, const TcpConnect& connect,
                             std::int64_t within_ns);

}  // namespace felt::hapticmaster
