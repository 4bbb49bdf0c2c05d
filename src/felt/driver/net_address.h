#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace felt {

/// A host and a TCP port, as TcpStream::connect takes them.
struct NetAddress {
  std::string host = "localhost";
  std::uint16_t port = 0;

  /// Returns "localhost:10001".
  [[nodiscard]] std::string text() const { return host + ":" + std::to_string(port); }
};

/// Parses "ws://localhost:10001", "192.168.0.25:7654", "[::1]" and the like: with or without
/// scheme, port and path. `usual_port` is used if the text names no port. Returns nullopt if the
/// host is empty or the port is not a number from 1 to 65535. Does not check the host.
std::optional<NetAddress> parse_net_address(std::string_view text, std::uint16_t usual_port);

}  // namespace felt
