// Reads any bytes as messages of Haply's service: WebSocket frames in pieces of any size, and the
// JSON in them. The first byte selects how the other bytes are split and interpreted.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "felt/devices/haply/service_messages.h"
#include "felt/devices/haply/web_socket.h"

namespace {

using namespace felt;
using namespace felt::haply;

class Pieces final : public ByteStream {
 public:
  Pieces(std::span<const std::byte> bytes, std::size_t size) : rest_(bytes), size_(size) {}
  tl::expected<void, StreamFault> send(std::span<const std::byte>, std::int64_t) noexcept override {
    return {};
  }
  tl::expected<std::size_t, StreamFault> receive(std::span<std::byte> room,
                                                 std::int64_t) noexcept override {
    if (rest_.empty()) return tl::unexpected(StreamFault::kClosed);
    const std::size_t count = std::min({room.size(), rest_.size(), size_});
    std::copy_n(rest_.begin(), count, room.begin());
    rest_ = rest_.subspan(count);
    return count;
  }

 private:
  std::span<const std::byte> rest_;
  std::size_t size_;
};

void must(bool is_true) {
  if (!is_true) std::abort();
}

void read_all(std::string_view text) {
  State state;
  if (read_state(text, "049D", "61548", state)) {
    must(is_finite(state.position_m) && is_finite(state.velocity_m_per_s));
  }
  if (const auto inventory = read_inventory(text)) {
    for (const InventoryDevice& device : inventory->devices) {
      must(device.id.find_first_of("\"\\") == std::string::npos);
      std::array<char, kMaxCommand> room{};
      const std::string_view command =
          write_command(device.id, ForceKey::kVector, {1, 2, 3}, room.data());
      State none;
      must(command.size() < room.size());
      must(read_state(command, device.id, "", none));  // our own commands are valid JSON
    }
  }
  static_cast<void>(read_event(text, "049D"));
  static_cast<void>(version_number(read_version(text)));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size < 1) return 0;
  const auto bytes = std::as_bytes(std::span(data, size)).subspan(1);
  if (data[0] == '{') {
    read_all({reinterpret_cast<const char*>(data), size});
    return 0;
  }
  const std::size_t piece = std::max<std::size_t>(1, data[0]);
  WebSocket socket(std::make_unique<Pieces>(bytes, piece), 3);
  for (int i = 0; i < 1000; ++i) {
    const auto message = socket.receive(0);
    if (!message) {
      if (message.error() == SocketFault::kTimedOut) continue;
      break;
    }
    must(message->size() <= WebSocket::kMaxBytes);
    read_all(*message);
  }
  return 0;
}
