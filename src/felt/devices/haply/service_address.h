#pragma once

#include <string>

#include "felt/driver/byte_stream.h"
#include "felt/driver/diagnosis.h"
#include "felt/driver/net_address.h"

namespace felt::haply {

inline constexpr const char* kUrlVariable = "FELT_HAPLY_URL";
inline constexpr const char* kEventsUrlVariable = "FELT_HAPLY_EVENTS_URL";
inline constexpr const char* kConfigFile =
    "/etc/haply-inverse-service/haply-inverse-service-config.json";

using Address = NetAddress;

/// The address of the service, and the source from which it was read.
struct ServiceAddress {
  Address control{.port = 10001};
  Address events{.port = 10020};
  std::string source;  ///< name of the variable or file; empty for the default addresses
  /// A sentence that says why a variable or the configuration file is invalid; otherwise empty. The
  /// other members are valid in both cases.
  std::string wrong;
};

/// Returns the address from the environment, or from the service's configuration file
/// ("communication/websocket/port", "communication/events/port"; maker's page "Settings
/// Reference"), or the default.
ServiceAddress service_address(const SystemView& system);

/// Sends GET for a path. Returns the JSON text in the answer, from the first brace to the last.
/// Fails if nothing listens, if no answer comes in time, or if the status is not 200.
Result<std::string> http_get(const TcpConnect& connect, const Address& address,
                             const std::string& path, std::int64_t within_ns);

}  // namespace felt::haply
