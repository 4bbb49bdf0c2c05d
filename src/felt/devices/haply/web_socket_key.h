#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace felt::haply {

/// Returns a WebSocket server's answer to a client's key, which proves that the server understands
/// the WebSocket protocol (RFC 6455, section 4.2.2): the base64 encoding of the SHA-1 hash of the
/// key followed by a fixed text. This is not a security feature.
std::string accept_for(std::string_view key);

/// Returns the base64 encoding of `bytes` (RFC 4648, section 4) with padding.
std::string base64(std::span<const std::byte> bytes);

}  // namespace felt::haply
