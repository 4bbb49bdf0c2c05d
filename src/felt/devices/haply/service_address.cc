#include "felt/devices/haply/service_address.h"

#include <array>
#include <optional>
#include <span>
#include <string_view>

#include "felt/devices/haply/json_walk.h"

namespace felt::haply {
namespace {

constexpr std::size_t kMaxListingBytes = std::size_t{1} << 17;

bool read_port(JsonScanner& json, std::uint16_t& port) {
  JsonScanner ahead = json;
  constexpr double kMax = 65535.0;
  if (ahead.next() == JsonToken::kNumber && ahead.number() >= 1.0 && ahead.number() <= kMax) {
    port = static_cast<std::uint16_t>(ahead.number());
  }
  return json.skip_value();
}

void from_config(const std::string& text, ServiceAddress& address) {
  JsonScanner json(text);
  ServiceAddress found = address;
  const bool is_read = walk_object(json, [&](std::string_view key) {
    if (key == "communication/websocket/port") return read_port(json, found.control.port);
    if (key == "communication/events/port") return read_port(json, found.events.port);
    return json.skip_value();
  });
  if (!is_read) {
    address.wrong = std::string(kConfigFile) + " is not valid JSON.";
    return;
  }
  const bool is_other =
      found.control.port != address.control.port || found.events.port != address.events.port;
  address = found;
  if (is_other) address.source = kConfigFile;
}

void from_variable(const SystemView& system, const char* name, Address& address,
                   ServiceAddress& whole) {
  const std::optional<std::string> url = system.environment(name);
  if (!url || url->empty()) return;
  if (const auto found = parse_net_address(*url, address.port)) {
    address = *found;
    whole.source = name;
  } else {
    whole.wrong = std::string(name) + " is \"" + *url + "\", which is not a valid address.";
  }
}

}  // namespace

ServiceAddress service_address(const SystemView& system) {
  ServiceAddress address;
  if (const auto config = system.read(kConfigFile)) from_config(*config, address);
  from_variable(system, kUrlVariable, address.control, address);
  from_variable(system, kEventsUrlVariable, address.events, address);
  return address;
}

Result<std::string> http_get(const TcpConnect& connect, const Address& address,
                             const std::string& path, std::int64_t within_ns) {
  auto stream = connect(address.host, address.port, within_ns);
  if (!stream) return tl::unexpected(stream.error());
  const StreamDeadline deadline(within_ns);
  const std::string request = "GET " + path + " HTTP/1.1\r\nHost: " + address.text() +
                              "\r\nAccept: application/json\r\nConnection: close\r\n\r\n";
  const auto bytes = std::as_bytes(std::span(request.data(), request.size()));
  const std::string where = "http://" + address.text() + path;
  if (!(*stream)->send(bytes, deadline.left_ns())) {
    return fail(ErrorCode::kIo, where + ": the connection was closed");
  }
  std::string answer;
  std::array<std::byte, 4096> room{};
  for (;;) {
    const auto count = (*stream)->receive(room, deadline.left_ns());
    if (!count && count.error() == StreamFault::kTimedOut) {
      return fail(ErrorCode::kIo, where + ": no answer");
    }
    if (!count) break;  // end of the answer: the request asked to close the connection
    answer.append(reinterpret_cast<const char*>(room.data()), *count);
    if (answer.size() > kMaxListingBytes)
      return fail(ErrorCode::kLimitExceeded, where + ": too long");
  }
  const std::string first = answer.substr(0, answer.find("\r\n"));
  if (first.find(" 200") == std::string::npos) {
    return fail(ErrorCode::kInvalidData, where + ": \"" + first + "\"");
  }
  // The body is one object, even if it comes in several chunks.
  const std::size_t begin = answer.find('{'), end = answer.rfind('}');
  if (begin == std::string::npos || end == std::string::npos || end < begin) {
    return fail(ErrorCode::kInvalidData, where + ": the answer is not JSON");
  }
  return answer.substr(begin, end - begin + 1);
}

}  // namespace felt::haply
