#include "tests/desktop/inputtest_pen.h"

#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <array>
#include <cstdint>
#include <cstring>
#include <utility>

namespace felt::desktop {
namespace {

// Each message begins with its length in bytes and its kind. The kinds are in the order of the
// protocol.
enum class Kind : std::uint32_t { kVersion, kWaitForSync, kMotion, kProximity, kButton };
enum class Answer : std::uint32_t { kVersion, kSynced };

struct Header {
  std::uint32_t size = 0;
  std::uint32_t kind = 0;
};

/// A set bit of `mask` means that the valuator of this number has a value: 0 is x, 1 is y, 4 is the
/// pressure.
struct Valuators {
  std::uint32_t has_unaccelerated = 0;
  std::array<std::uint8_t, 8> mask{};
  std::array<double, 64> values{};
  std::array<double, 64> unaccelerated{};
};

struct Version {
  Header header;
  std::uint16_t major = 1;
  std::uint16_t minor = 1;
};
struct Motion {
  Header header;
  std::uint32_t is_absolute = 1;
  Valuators valuators;
};
struct Proximity {
  Header header;
  std::uint32_t is_in = 0;
  Valuators valuators;
};
struct Button {
  Header header;
  std::int32_t is_absolute = 1;
  std::int32_t button = 1;
  std::uint32_t is_press = 0;
  Valuators valuators;
};

template <class Message>
Message make(Kind kind) {
  Message message;
  message.header = {sizeof(Message), static_cast<std::uint32_t>(kind)};
  return message;
}

Valuators at(double x, double y, double pressure) {
  Valuators valuators;
  valuators.mask[0] = 1U << 0 | 1U << 1 | 1U << 4;
  valuators.values[0] = x;
  valuators.values[1] = y;
  valuators.values[4] = pressure;
  return valuators;
}

}  // namespace

Result<InputtestPen> InputtestPen::open(const std::string& socket_path) {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  if (socket_path.size() >= sizeof address.sun_path) {
    return fail(ErrorCode::kInvalidArgument, socket_path + ": the path is too long for a socket");
  }
  std::memcpy(address.sun_path, socket_path.c_str(), socket_path.size() + 1);
  InputtestPen pen(socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0));
  if (connect(pen.fd_, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0) {
    return fail(ErrorCode::kNotFound, socket_path + ": " + std::strerror(errno));
  }
  const auto ours = make<Version>(Kind::kVersion);
  Version theirs;
  if (!pen.send(&ours, sizeof ours) || !pen.receive(&theirs, sizeof theirs) ||
      theirs.header.kind != static_cast<std::uint32_t>(Answer::kVersion)) {
    return fail(ErrorCode::kInvalidData, socket_path + ": the driver speaks another version");
  }
  return pen;
}

InputtestPen::InputtestPen(InputtestPen&& other) noexcept : fd_(std::exchange(other.fd_, -1)) {}

InputtestPen::~InputtestPen() {
  if (fd_ >= 0) close(fd_);
}

bool InputtestPen::send(const void* message, std::size_t size) const {
  return ::send(fd_, message, size, MSG_NOSIGNAL) == static_cast<ssize_t>(size);
}

bool InputtestPen::receive(void* message, std::size_t size) const {
  return recv(fd_, message, size, MSG_WAITALL) == static_cast<ssize_t>(size);
}

bool InputtestPen::come(double x, double y) {
  auto message = make<Proximity>(Kind::kProximity);
  message.is_in = 1;
  message.valuators = at(x, y, 0.0);
  return send(&message, sizeof message);
}

bool InputtestPen::leave(double x, double y) {
  auto message = make<Proximity>(Kind::kProximity);
  message.valuators = at(x, y, 0.0);
  return send(&message, sizeof message);
}

bool InputtestPen::move(double x, double y, double pressure) {
  auto message = make<Motion>(Kind::kMotion);
  message.valuators = at(x, y, pressure);
  return send(&message, sizeof message);
}

bool InputtestPen::press(bool down, double x, double y, double pressure) {
  auto message = make<Button>(Kind::kButton);
  message.is_press = down ? 1 : 0;
  message.valuators = at(x, y, pressure);
  return send(&message, sizeof message);
}

bool InputtestPen::sync() {
  const Header ask{sizeof(Header), static_cast<std::uint32_t>(Kind::kWaitForSync)};
  Header answer;
  return send(&ask, sizeof ask) && receive(&answer, sizeof answer);
}

}  // namespace felt::desktop
