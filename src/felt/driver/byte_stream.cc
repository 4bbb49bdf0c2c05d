#include "felt/driver/byte_stream.h"

#include <arpa/inet.h>
#include <fcntl.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/file.h>
#include <sys/ioctl.h>
#include <sys/socket.h>
#include <termios.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <optional>
#include <utility>

#include "felt/base/constants.h"

namespace felt {
namespace {

std::int64_t monotonic_ns() noexcept {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  return std::int64_t{now.tv_sec} * kSecond + now.tv_nsec;
}

// Waits until the descriptor is ready, at most until `until_ns` on the monotonic clock. Returns
// false if it was not ready in time. An error of the descriptor counts as ready, because the
// transfer that follows reports it.
bool wait_for(int descriptor, short events, std::int64_t until_ns) noexcept {
  for (;;) {
    const std::int64_t left_ns = std::max<std::int64_t>(0, until_ns - monotonic_ns());
    const timespec left{.tv_sec = left_ns / kSecond, .tv_nsec = left_ns % kSecond};
    pollfd wanted{.fd = descriptor, .events = events, .revents = 0};
    const int ready = ppoll(&wanted, 1, &left, nullptr);
    if (ready > 0) return true;
    if (ready == 0) return false;
    if (errno != EINTR) return true;
  }
}

bool would_block(int error) noexcept {
  return error == EAGAIN || error == EINTR;
}

bool is_gone(int error) noexcept {
  return error == EPIPE || error == ECONNRESET || error == ENXIO || error == ENODEV || error == EIO;
}

class Owned {
 public:
  explicit Owned(int descriptor) noexcept : descriptor_(descriptor) {}
  Owned(const Owned&) = delete;
  Owned& operator=(const Owned&) = delete;
  ~Owned() {
    if (descriptor_ >= 0) ::close(descriptor_);
  }
  [[nodiscard]] int get() const noexcept { return descriptor_; }
  int release() noexcept { return std::exchange(descriptor_, -1); }

 private:
  int descriptor_;
};

struct Address {
  sockaddr_storage storage{};
  socklen_t size = 0;
};

std::optional<Address> numeric_address(const std::string& host, std::uint16_t port) {
  Address address;
  auto* four = reinterpret_cast<sockaddr_in*>(&address.storage);
  if (inet_pton(AF_INET, host.c_str(), &four->sin_addr) == 1) {
    four->sin_family = AF_INET;
    four->sin_port = htons(port);
    address.size = sizeof(sockaddr_in);
    return address;
  }
  auto* six = reinterpret_cast<sockaddr_in6*>(&address.storage);
  if (inet_pton(AF_INET6, host.c_str(), &six->sin6_addr) == 1) {
    six->sin6_family = AF_INET6;
    six->sin6_port = htons(port);
    address.size = sizeof(sockaddr_in6);
    return address;
  }
  return std::nullopt;
}

// Makes the system notice within about three seconds that the peer cannot be reached any more, also
// on a connection on which nothing is sent, such as that of a guard.
void keep_alive(int socket) {
  constexpr int kOn = 1, kSeconds = 1, kProbes = 3;
  constexpr unsigned kTimeoutMs = 3000;
  setsockopt(socket, SOL_SOCKET, SO_KEEPALIVE, &kOn, sizeof kOn);
  setsockopt(socket, IPPROTO_TCP, TCP_KEEPIDLE, &kSeconds, sizeof kSeconds);
  setsockopt(socket, IPPROTO_TCP, TCP_KEEPINTVL, &kSeconds, sizeof kSeconds);
  setsockopt(socket, IPPROTO_TCP, TCP_KEEPCNT, &kProbes, sizeof kProbes);
  setsockopt(socket, IPPROTO_TCP, TCP_USER_TIMEOUT, &kTimeoutMs, sizeof kTimeoutMs);
}

// Connects the socket to the address. Returns 0, or errno.
int connect_within(int socket, const Address& address, std::int64_t within_ns) {
  const std::int64_t until_ns = monotonic_ns() + within_ns;
  if (::connect(socket, reinterpret_cast<const sockaddr*>(&address.storage), address.size) == 0) {
    return 0;
  }
  if (errno != EINPROGRESS) return errno;
  if (!wait_for(socket, POLLOUT, until_ns)) return ETIMEDOUT;
  int error = 0;
  socklen_t size = sizeof error;
  if (getsockopt(socket, SOL_SOCKET, SO_ERROR, &error, &size) != 0) return errno;
  return error;
}

// Sets the port to raw mode, in which bytes are not changed. Returns 0, or errno.
int make_raw(int port) {
  if (flock(port, LOCK_EX | LOCK_NB) != 0) return errno;
  if (ioctl(port, TIOCEXCL) != 0) return errno;
  termios settings{};
  if (tcgetattr(port, &settings) != 0) return errno;
  cfmakeraw(&settings);
  settings.c_cflag |= CLOCAL | CREAD;
  settings.c_cc[VMIN] = 1;  // read() returns EAGAIN if no byte is waiting, and 0 after unplugging
  settings.c_cc[VTIME] = 0;
  // The rate has no effect on USB, but must never be 1200, because that starts the boot loader of
  // many boards.
  cfsetspeed(&settings, B115200);
  if (tcsetattr(port, TCSANOW, &settings) != 0) return errno;
  return tcflush(port, TCIOFLUSH) == 0 ? 0 : errno;
}

}  // namespace

StreamDeadline::StreamDeadline(std::int64_t within_ns) noexcept
    : until_ns_(within_ns > 0 ? monotonic_ns() + within_ns : 0) {}

std::int64_t StreamDeadline::left_ns() const noexcept {
  return until_ns_ == 0 ? 0 : std::max<std::int64_t>(0, until_ns_ - monotonic_ns());
}

DescriptorStream::~DescriptorStream() {
  ::close(descriptor_);
}

tl::unexpected<StreamFault> DescriptorStream::end(StreamFault fault, int error) noexcept {
  is_over_ = true;
  fault_ = fault;
  errno_ = error;
  return tl::unexpected(fault);
}

tl::expected<void, StreamFault> DescriptorStream::send(std::span<const std::byte> bytes,
                                                       std::int64_t within_ns) noexcept {
  if (is_over_) return tl::unexpected(fault_);
  const std::int64_t until_ns = monotonic_ns() + within_ns;
  std::size_t sent = 0;
  while (sent < bytes.size()) {
    const std::span<const std::byte> rest = bytes.subspan(sent);
    const ssize_t count = is_socket_ ? ::send(descriptor_, rest.data(), rest.size(), MSG_NOSIGNAL)
                                     : ::write(descriptor_, rest.data(), rest.size());
    if (count > 0) {
      sent += static_cast<std::size_t>(count);
      continue;
    }
    const int error = errno;
    if (count < 0 && !would_block(error)) {
      return end(is_gone(error) ? StreamFault::kClosed : StreamFault::kFailed, error);
    }
    if (wait_for(descriptor_, POLLOUT, until_ns)) continue;
    if (sent == 0) return tl::unexpected(StreamFault::kTimedOut);
    return end(StreamFault::kFailed, ETIMEDOUT);  // a part was sent, and cannot be taken back
  }
  return {};
}

tl::expected<std::size_t, StreamFault> DescriptorStream::receive(std::span<std::byte> room,
                                                                 std::int64_t within_ns) noexcept {
  if (is_over_) return tl::unexpected(fault_);
  const std::int64_t until_ns = monotonic_ns() + within_ns;
  for (;;) {
    const ssize_t count = is_socket_ ? ::recv(descriptor_, room.data(), room.size(), 0)
                                     : ::read(descriptor_, room.data(), room.size());
    if (count > 0) return static_cast<std::size_t>(count);
    const int error = errno;
    if (count == 0) return end(StreamFault::kClosed, 0);
    if (!would_block(error)) {
      return end(is_gone(error) ? StreamFault::kClosed : StreamFault::kFailed, error);
    }
    if (within_ns <= 0 || !wait_for(descriptor_, POLLIN, until_ns)) {
      return tl::unexpected(StreamFault::kTimedOut);
    }
  }
}

Result<std::unique_ptr<ByteStream>> TcpStream::connect(const std::string& host, std::uint16_t port,
                                                       std::int64_t within_ns) {
  const bool is_here = host == "localhost";
  const std::string place = host + ":" + std::to_string(port);
  int error = 0;
  for (const char* const name : {is_here ? "127.0.0.1" : host.c_str(), is_here ? "::1" : ""}) {
    if (*name == '\0') break;
    const std::optional<Address> address = numeric_address(name, port);
    if (!address) {
      return fail(ErrorCode::kInvalidArgument,
                  "\"" + host + "\" is neither \"localhost\" nor an IP address");
    }
    Owned socket(
        ::socket(address->storage.ss_family, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0));
    if (socket.get() < 0) {
      if (error == 0) error = errno;
      continue;
    }
    const int refused = connect_within(socket.get(), *address, within_ns);
    if (refused == 0) {
      const int on = 1;
      setsockopt(socket.get(), IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
      keep_alive(socket.get());
      return std::unique_ptr<ByteStream>(new TcpStream(socket.release()));
    }
    if (error == 0) error = refused;  // the error of IPv4
  }
  return fail(error == ECONNREFUSED ? ErrorCode::kNotFound : ErrorCode::kIo,
              place + ": " + std::strerror(error));
}

Result<std::unique_ptr<ByteStream>> SerialStream::open(const std::string& path) {
  Owned port(::open(path.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC));
  int error = port.get() < 0 ? errno : make_raw(port.get());
  if (error == 0) return std::unique_ptr<ByteStream>(new SerialStream(port.release()));
  if (error == EWOULDBLOCK || error == EBUSY) {
    return fail(ErrorCode::kIo, path + ": in use by another program");
  }
  if (error == ENOTTY) return fail(ErrorCode::kInvalidArgument, path + ": not a serial port");
  return fail(error == ENOENT ? ErrorCode::kNotFound : ErrorCode::kIo,
              path + ": " + std::strerror(error));
}

tl::expected<void, StreamFault> SerialStream::send(std::span<const std::byte> bytes,
                                                   std::int64_t within_ns) noexcept {
  auto sent = DescriptorStream::send(bytes, within_ns);
  if (sent) beat();
  return sent;
}

void GuardedStream::beat() noexcept {
  if (guard_) is_guarded_ = guard_->beat();
}

bool GuardedStream::keep_guard(std::span<const std::byte> last_words, std::int64_t patience_ns) {
  guard_.reset();
  is_guarded_ = true;
  if (!last_words.empty()) {
    guard_ = PortGuard::start(descriptor(), last_words, patience_ns, use_);
  }
  return guard_ != nullptr;
}

}  // namespace felt
