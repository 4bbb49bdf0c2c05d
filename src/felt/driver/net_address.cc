#include "felt/driver/net_address.h"

#include <charconv>

namespace felt {
namespace {

std::optional<std::uint16_t> port_of(std::string_view digits) {
  std::uint16_t port = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), port);
  if (error != std::errc{} || end != digits.data() + digits.size() || port == 0) return {};
  return port;
}

}  // namespace

std::optional<NetAddress> parse_net_address(std::string_view text, std::uint16_t usual_port) {
  for (const std::string_view scheme : {"ws://", "http://"}) {
    if (text.starts_with(scheme)) text.remove_prefix(scheme.size());
  }
  text = text.substr(0, text.find('/'));
  NetAddress address{.port = usual_port};
  const std::size_t colon = text.rfind(':');
  const bool is_bracketed = text.ends_with(']');
  if (colon != std::string_view::npos && !is_bracketed) {
    const auto port = port_of(text.substr(colon + 1));
    if (!port) return std::nullopt;
    address.port = *port;
    text = text.substr(0, colon);
  }
  if (text.starts_with('[') && text.ends_with(']')) text = text.substr(1, text.size() - 2);
  if (text.empty()) return std::nullopt;
  address.host = text;
  return address;
}

}  // namespace felt
