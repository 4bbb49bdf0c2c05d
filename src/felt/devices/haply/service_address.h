#pragma once

#include <cstdint>
#include <string>

#include "felt/driver/byte_stream.h"
#include "felt/driver/diagnosis.h"

namespace felt::haply {

inline constexpr const char* kUrlVariable = "FELT_HAPLY_URL";
inline constexpr const char* kEventsUrlVariable = "FELT_HAPLY_EVENTS_URL";
inline constexpr const char* kConfigFile =
    "/etc/haply-inverse-service/haply-inverse-service-config.json";

struct Address {
  std::string host = "localhost";
  std::uint16_t port = 0;

  [[nodiscard]] std::string text() const { return host + ":" + std::to_string(port); }
};

/// Where the service should be, and who says so.
struct ServiceAddress {
  Address control{.port = 10001};
  Address events{.port = 10020};
  std::string source;  ///< "FELT_HAPLY_URL", the configuration file, or empty: the usual ports
  std::string wrong;   ///< a sentence, where what was said cannot be read; the rest then holds
};

/// From the environment, or the service's configuration file ("communication/websocket/port",
/// "communication/events/port"; maker's page "Settings Reference"), or as usual.
ServiceAddress service_address(const SystemView& system);

/// GET of a path; the JSON text of the answer (what lies between its first and its last brace).
/// Error: nobody there, no answer in time, or a status that is not 200.
Result<std::string> http_get(const TcpConnect& connect, const Address& address,
                             const std::string& path, std::int64_t within_ns);

}  // namespace felt::haply
