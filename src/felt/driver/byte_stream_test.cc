#include "felt/driver/byte_stream.h"

#include <arpa/inet.h>
#include <fcntl.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <stdlib.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

namespace felt::byte_stream_test {
namespace {

constexpr std::int64_t kSoonNs = 5'000'000;
constexpr std::int64_t kLongNs = 5'000'000'000;  // an upper bound; no test waits that long

std::span<const std::byte> bytes_of(std::string_view text) {
  return std::as_bytes(std::span(text.data(), text.size()));
}

std::string receive_text(ByteStream& stream, std::size_t size) {
  std::string text;
  std::array<std::byte, 64> room{};
  while (text.size() < size) {
    const auto count = stream.receive(room, kLongNs);
    if (!count) break;
    text.append(reinterpret_cast<const char*>(room.data()), *count);
  }
  return text;
}

class Listener {
 public:
  Listener() {
    socket_ = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    EXPECT_EQ(bind(socket_, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
    EXPECT_EQ(listen(socket_, 1), 0);
    socklen_t size = sizeof address;
    EXPECT_EQ(getsockname(socket_, reinterpret_cast<sockaddr*>(&address), &size), 0);
    port_ = ntohs(address.sin_port);
  }
  Listener(const Listener&) = delete;
  Listener& operator=(const Listener&) = delete;
  ~Listener() {
    close_other();
    if (socket_ >= 0) ::close(socket_);
  }
  [[nodiscard]] std::uint16_t port() const { return port_; }
  int accept_one() { return other_ = ::accept(socket_, nullptr, nullptr); }
  void close_other() {
    if (other_ >= 0) ::close(other_);
    other_ = -1;
  }
  void close_listening() {
    ::close(socket_);
    socket_ = -1;
  }

 private:
  int socket_ = -1;
  int other_ = -1;
  std::uint16_t port_ = 0;
};

TEST(TcpStream, SendsAndReceivesAndSaysWhenTheOtherSideLeft) {
  Listener listener;
  auto stream = TcpStream::connect("localhost", listener.port(), kLongNs);
  ASSERT_TRUE(stream.has_value()) << stream.error().message;
  const int other = listener.accept_one();
  ASSERT_TRUE((*stream)->send(bytes_of("ping"), kLongNs).has_value());
  std::array<char, 8> received{};
  ASSERT_EQ(::recv(other, received.data(), 4, MSG_WAITALL), 4);
  EXPECT_EQ(std::string_view(received.data(), 4), "ping");
  ASSERT_EQ(::send(other, "pong!", 5, 0), 5);
  EXPECT_EQ(receive_text(**stream, 5), "pong!");
  std::array<std::byte, 4> room{};
  EXPECT_EQ((*stream)->receive(room, 0).error(), StreamFault::kTimedOut);
  EXPECT_EQ((*stream)->receive(room, kSoonNs).error(), StreamFault::kTimedOut);
  listener.close_other();
  EXPECT_EQ((*stream)->receive(room, kLongNs).error(), StreamFault::kClosed);
  EXPECT_EQ((*stream)->receive(room, kLongNs).error(), StreamFault::kClosed);
  EXPECT_EQ((*stream)->send(bytes_of("x"), kLongNs).error(), StreamFault::kClosed);
}

// The peer does not read. The sent messages fill the buffers until send() times out. If only part
// of a message was sent, the stream is closed, because the peer could not find the start of the
// next message.
TEST(TcpStream, HalfAMessageEndsTheStream) {
  Listener listener;
  auto stream = TcpStream::connect("127.0.0.1", listener.port(), kLongNs);
  ASSERT_TRUE(stream.has_value());
  listener.accept_one();
  const std::vector<std::byte> much(std::size_t{64} << 20);
  EXPECT_EQ((*stream)->send(much, kSoonNs).error(), StreamFault::kFailed);
  EXPECT_EQ((*stream)->last_errno(), ETIMEDOUT);
  std::array<std::byte, 1> one{};
  EXPECT_EQ((*stream)->send(one, kSoonNs).error(), StreamFault::kFailed);
}

TEST(TcpStream, NobodyListens) {
  Listener listener;
  listener.close_listening();
  auto stream = TcpStream::connect("localhost", listener.port(), kLongNs);
  ASSERT_FALSE(stream.has_value());
  EXPECT_EQ(stream.error().code, ErrorCode::kNotFound);
  EXPECT_NE(stream.error().message.find("localhost:" + std::to_string(listener.port())),
            std::string::npos);
}

TEST(TcpStream, NamesAreNotLookedUp) {
  auto stream = TcpStream::connect("haply.example", 10001, kLongNs);
  ASSERT_FALSE(stream.has_value());
  EXPECT_EQ(stream.error().code, ErrorCode::kInvalidArgument);
}

class Pty {
 public:
  Pty() {
    board_ = posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC);
    EXPECT_EQ(grantpt(board_), 0);
    EXPECT_EQ(unlockpt(board_), 0);
    std::array<char, 128> name{};
    EXPECT_EQ(ptsname_r(board_, name.data(), name.size()), 0);
    path_ = name.data();
  }
  Pty(const Pty&) = delete;
  Pty& operator=(const Pty&) = delete;
  ~Pty() { unplug(); }
  [[nodiscard]] int board() const { return board_; }
  [[nodiscard]] const std::string& path() const { return path_; }
  void unplug() {
    if (board_ >= 0) ::close(board_);
    board_ = -1;
  }

 private:
  int board_ = -1;
  std::string path_;
};

// Bytes that a terminal would change or interpret must arrive unchanged.
TEST(SerialStream, BytesAreRaw) {
  Pty pty;
  auto port = SerialStream::open(pty.path());
  ASSERT_TRUE(port.has_value()) << port.error().message;
  constexpr std::string_view kOdd("\x03\r\n\x11\x13\x04\xff\0\x1a", 9);
  ASSERT_TRUE((*port)->send(bytes_of(kOdd), kLongNs).has_value());
  std::array<char, 16> received{};
  ASSERT_EQ(::read(pty.board(), received.data(), received.size()), 9);
  EXPECT_EQ(std::string_view(received.data(), 9), kOdd);
  ASSERT_EQ(::write(pty.board(), kOdd.data(), kOdd.size()), 9);
  EXPECT_EQ(receive_text(**port, 9), kOdd);
}

TEST(SerialStream, NothingThereIsNotUnplugged) {
  Pty pty;
  auto port = SerialStream::open(pty.path());
  ASSERT_TRUE(port.has_value());
  std::array<std::byte, 4> room{};
  EXPECT_EQ((*port)->receive(room, 0).error(), StreamFault::kTimedOut);
  EXPECT_EQ((*port)->receive(room, kSoonNs).error(), StreamFault::kTimedOut);
  pty.unplug();
  EXPECT_EQ((*port)->receive(room, kLongNs).error(), StreamFault::kClosed);
  EXPECT_EQ((*port)->send(room, kLongNs).error(), StreamFault::kClosed);
}

TEST(SerialStream, OneProgramAtATime) {
  Pty pty;
  auto first = SerialStream::open(pty.path());
  ASSERT_TRUE(first.has_value());
  auto second = SerialStream::open(pty.path());
  ASSERT_FALSE(second.has_value());
  EXPECT_NE(second.error().message.find("another program"), std::string::npos);
  first->reset();
  EXPECT_TRUE(SerialStream::open(pty.path()).has_value());
}

TEST(SerialStream, AGuardSpeaksAtTheEndAndFreesThePort) {
  Pty pty;
  auto port = SerialStream::open(pty.path());
  ASSERT_TRUE(port.has_value());
  ASSERT_TRUE((*port)->keep_guard(bytes_of("farewell"), 3'600'000'000'000));
  ASSERT_TRUE((*port)->send(bytes_of("hello "), kLongNs).has_value());
  port->reset();
  EXPECT_TRUE(SerialStream::open(pty.path()).has_value());
}

// The guard sends its message if the program has sent no bytes for a while. Received bytes do not
// count.
TEST(SerialStream, AGuardSpeaksAfterASilence) {
  Pty pty;
  auto port = SerialStream::open(pty.path());
  ASSERT_TRUE(port.has_value());
  ASSERT_TRUE((*port)->keep_guard(bytes_of("farewell"), 20'000'000));
  ASSERT_TRUE((*port)->send(bytes_of("hello "), kLongNs).has_value());
  std::string received;
  std::array<char, 16> room{};
  while (received.size() < 14) {
    const ssize_t count = ::read(pty.board(), room.data(), room.size());
    if (count <= 0) break;
    received.append(room.data(), static_cast<std::size_t>(count));
  }
  EXPECT_EQ(received, "hello farewell");
}

TEST(SerialStream, WhatIsNoPortSaysSo) {
  EXPECT_EQ(SerialStream::open("/dev/felt-no-such-port").error().code, ErrorCode::kNotFound);
  const auto null = SerialStream::open("/dev/null");
  ASSERT_FALSE(null.has_value());
  EXPECT_NE(null.error().message.find("not a serial port"), std::string::npos);
}

}  // namespace
}  // namespace felt::byte_stream_test
