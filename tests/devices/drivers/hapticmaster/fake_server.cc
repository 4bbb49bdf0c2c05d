#include "tests/devices/drivers/hapticmaster/fake_server.h"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <span>
#include <string>
#include <utility>

namespace felt::hapticmaster {
namespace {

std::int64_t clock_ns() {
  return std::chrono::steady_clock::now().time_since_epoch() / std::chrono::nanoseconds(1);
}

}  // namespace

FakeServer::FakeServer(FakeController& controller)
    : controller_(controller), begin_ns_(clock_ns()) {
  listener_ = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t size = sizeof address;
  auto* const any = reinterpret_cast<sockaddr*>(&address);
  const bool is_ready = ::bind(listener_, any, size) == 0 && ::listen(listener_, 8) == 0 &&
                        ::getsockname(listener_, any, &size) == 0;
  if (is_ready) port_ = ntohs(address.sin_port);
}

FakeServer::~FakeServer() {
  for (const Line& line : lines_) ::close(line.socket);
  ::close(listener_);
}

std::int64_t FakeServer::now_ns() const noexcept {
  return clock_ns() - begin_ns_;
}

void FakeServer::accept_line() {
  const int socket = ::accept4(listener_, nullptr, nullptr, SOCK_CLOEXEC | SOCK_NONBLOCK);
  if (socket < 0) return;
  const int on = 1;
  setsockopt(socket, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
  lines_.push_back({socket, std::make_unique<FakeController::Port>(controller_)});
}

// Returns false if the client has closed the connection.
bool FakeServer::transfer(Line& line) {
  std::array<std::byte, 1024> room{};
  const ssize_t count = ::recv(line.socket, room.data(), room.size(), MSG_DONTWAIT);
  if (count == 0 || (count < 0 && errno != EAGAIN && errno != EINTR)) return false;
  if (count > 0) line.port->take(std::span(room).first(static_cast<std::size_t>(count)));
  std::string& out = line.port->out();
  if (!out.empty() && ::send(line.socket, out.data(), out.size(), MSG_NOSIGNAL) >= 0) out.clear();
  return true;
}

void FakeServer::serve() {
  std::vector<pollfd> waits{{.fd = listener_, .events = POLLIN, .revents = 0}};
  const std::span<const Line> served = std::span(lines_).subspan(is_first_stalled_ ? 1 : 0);
  for (const Line& line : served) {
    waits.push_back({.fd = line.socket, .events = POLLIN, .revents = 0});
  }
  poll(waits.data(), waits.size(), 1);
  controller_.tick(now_ns());
  if (waits[0].revents != 0) accept_line();
  const int stalled = is_first_stalled_ ? lines_.front().socket : -1;
  std::erase_if(lines_, [stalled](Line& line) {
    if (line.socket == stalled || transfer(line)) return false;
    ::close(line.socket);
    return true;
  });
}

}  // namespace felt::hapticmaster
