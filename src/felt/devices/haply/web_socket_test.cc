#include "felt/devices/haply/web_socket.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <deque>
#include <string>

#include "felt/devices/haply/web_socket_key.h"

namespace felt::haply::web_socket_test {
namespace {

// A scripted server: the pieces in which its bytes arrive, and the bytes that it received.
struct Script {
  std::deque<std::string> pieces;
  std::string received;
  bool is_closed = false;
  bool takes_nothing = false;
};

class ScriptedStream final : public ByteStream {
 public:
  explicit ScriptedStream(Script& script) : script_(script) {}
  tl::expected<void, StreamFault> send(std::span<const std::byte> bytes,
                                       std::int64_t) noexcept override {
    if (script_.takes_nothing) return tl::unexpected(StreamFault::kTimedOut);
    script_.received.append(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    return {};
  }
  tl::expected<std::size_t, StreamFault> receive(std::span<std::byte> room,
                                                 std::int64_t) noexcept override {
    if (script_.pieces.empty()) {
      return tl::unexpected(script_.is_closed ? StreamFault::kClosed : StreamFault::kTimedOut);
    }
    std::string& piece = script_.pieces.front();
    const std::size_t count = std::min(room.size(), piece.size());
    std::copy_n(std::as_bytes(std::span(piece)).begin(), count, room.begin());
    piece.erase(0, count);
    if (piece.empty()) script_.pieces.pop_front();
    return count;
  }

 private:
  Script& script_;
};

std::string frame(int first, std::string_view payload) {
  std::string bytes(1, static_cast<char>(first));
  if (payload.size() < 126) {
    bytes += static_cast<char>(payload.size());
  } else {
    bytes += '\x7f';
    for (int shift = 56; shift >= 0; shift -= 8) {
      bytes += static_cast<char>((std::uint64_t{payload.size()} >> shift) & 0xFF);
    }
  }
  return bytes + std::string(payload);
}

class WebSocketTest : public ::testing::Test {
 protected:
  WebSocket& socket() {
    if (!socket_)
      socket_ = std::make_unique<WebSocket>(std::make_unique<ScriptedStream>(script), 5);
    return *socket_;
  }
  void say(const std::string& bytes) { script.pieces.push_back(bytes); }
  std::string received_message() {
    const auto message = socket().receive(0);
    return message ? std::string(*message) : "(nothing)";
  }

  Script script;
  std::unique_ptr<WebSocket> socket_;
};

// Uses the example of RFC 6455, section 1.3.
TEST(WebSocketKey, IsAcceptedAsTheStandardSays) {
  EXPECT_EQ(accept_for("dGhlIHNhbXBsZSBub25jZQ=="), "s3pPLMBiTxaQ9kYGzzhZRbK+xOo=");
  const auto of = [](std::string_view text) {
    return base64(std::as_bytes(std::span(text.data(), text.size())));
  };
  EXPECT_EQ(of(""), "");  // RFC 4648, section 10
  EXPECT_EQ(of("f"), "Zg==");
  EXPECT_EQ(of("fo"), "Zm8=");
  EXPECT_EQ(of("foo"), "Zm9v");
  EXPECT_EQ(of("foobar"), "Zm9vYmFy");
}

TEST_F(WebSocketTest, WhatIsSentIsMaskedText) {
  ASSERT_TRUE(socket().send("Hello", 0).has_value());
  const std::string& bytes = script.received;
  ASSERT_EQ(bytes.size(), 11u);
  EXPECT_EQ(bytes[0], '\x81');
  EXPECT_EQ(bytes[1], '\x85');
  std::string text;
  for (std::size_t i = 0; i < 5; ++i) text += static_cast<char>(bytes[6 + i] ^ bytes[2 + i % 4]);
  EXPECT_EQ(text, "Hello");
  EXPECT_NE(bytes.substr(6), "Hello");
  script.received.clear();
  ASSERT_TRUE(socket().send(std::string(300, 'x'), 0).has_value());
  EXPECT_EQ(script.received.size(), 300u + 8u);
  EXPECT_FALSE(socket().send(std::string(WebSocket::kMaxSent + 1, 'x'), 0).has_value());
}

TEST_F(WebSocketTest, MessagesComeHoweverTheyAreCut) {
  const std::string whole = frame(0x81, "one") + frame(0x81, std::string(40000, 'y')) +
                            frame(0x01, "fr") + frame(0x89, "ping?") + frame(0x00, "agm") +
                            frame(0x80, "ents") + frame(0x81, "");
  for (const char c : whole) say(std::string(1, c));
  EXPECT_EQ(received_message(), "one");
  EXPECT_EQ(received_message(), std::string(40000, 'y'));
  EXPECT_EQ(received_message(), "fragments");
  EXPECT_EQ(received_message(), "");
  EXPECT_EQ(socket().receive(0).error(), SocketFault::kTimedOut);
  // The ping was answered with its own payload.
  ASSERT_EQ(script.received.size(), 2u + 4u + 5u);
  EXPECT_EQ(script.received[0], '\x8A');
}

TEST_F(WebSocketTest, GoodByeIsSaidOnce) {
  say(frame(0x88, std::string("\x03\xe9", 2)));
  EXPECT_EQ(socket().receive(0).error(), SocketFault::kClosed);
  EXPECT_EQ(socket().receive(0).error(), SocketFault::kClosed);
  EXPECT_EQ(socket().send("x", 0).error(), SocketFault::kClosed);
  socket().close();
  EXPECT_EQ(script.received.size(), 2u + 4u + 2u);
}

TEST_F(WebSocketTest, TheEndOfTheStreamIsTheEnd) {
  say(frame(0x81, "cut").substr(0, 3));
  script.is_closed = true;
  EXPECT_EQ(socket().receive(0).error(), SocketFault::kClosed);
}

TEST_F(WebSocketTest, WhatIsNotTakenInTimeMayBeTriedAgain) {
  script.takes_nothing = true;
  EXPECT_EQ(socket().send("x", 0).error(), SocketFault::kTimedOut);
  script.takes_nothing = false;
  EXPECT_TRUE(socket().send("x", 0).has_value());
}

class BadFrames : public WebSocketTest, public ::testing::WithParamInterface<std::string> {};

TEST_P(BadFrames, EndTheConnection) {
  say(GetParam());
  say(frame(0x81, "never"));
  EXPECT_EQ(socket().receive(0).error(), SocketFault::kBadData);
  EXPECT_EQ(socket().receive(0).error(), SocketFault::kBadData);
}

INSTANTIATE_TEST_SUITE_P(
    , BadFrames,
    ::testing::Values(std::string("\x81\x80mask", 6),      // a masked frame of a server
                      std::string("\xC1\x00", 2),          // a reserved bit without an extension
                      std::string("\x82\x01x", 3),         // a binary message
                      std::string("\x83\x00", 2),          // an unknown opcode
                      std::string("\x80\x00", 2),          // a continuation without a first frame
                      std::string("\x01\x00\x81\x00", 4),  // a new message inside another message
                      std::string("\x09\x00", 2),          // a ping in fragments
                      std::string("\x89\x7e\x00\x7e", 4),  // a ping that is too long
                      std::string("\x81\x7f\xff\xff\xff\xff\xff\xff\xff\xff", 10),
                      std::string("\x81\x7f\x00\x00\x00\x00\x00\x01\x00\x01", 10)));

TEST_F(WebSocketTest, FragmentsDoNotGrowWithoutEnd) {
  say(frame(0x01, std::string(60000, 'a')));
  say(frame(0x00, std::string(60000, 'a')));
  EXPECT_EQ(socket().receive(0).error(), SocketFault::kBadData);
}

TEST_F(WebSocketTest, AFloodOfPingsTakesNoTickForEver) {
  std::string flood;
  for (int i = 0; i < 1000; ++i) flood += frame(0x8A, "");
  say(flood);
  EXPECT_EQ(socket().receive(0).error(), SocketFault::kTimedOut);
  EXPECT_TRUE(script.pieces.empty());
}

std::string error_of(const std::string& answer) {
  Script script;
  script.pieces.push_back(answer);
  script.is_closed = true;
  const auto socket =
      WebSocket::open(std::make_unique<ScriptedStream>(script), "localhost:1", 5, 0);
  return socket ? "" : socket.error().message;
}

TEST(WebSocketOpening, AnythingButTheRightAnswerIsRefused) {
  EXPECT_NE(error_of("HTTP/1.1 404 Not Found\r\n\r\n").find("404"), std::string::npos);
  EXPECT_NE(error_of("HTTP/1.1 101 S\r\nUpgrade: websocket\r\nSec-WebSocket-Accept: x\r\n\r\n"),
            "");
  EXPECT_NE(error_of("HTTP/1.1 101 S\r\n\r\n"), "");
  EXPECT_NE(error_of(std::string(20000, 'h')), "");
  EXPECT_NE(error_of("SSH-2.0-OpenSSH_9.2\r\n"), "");
}

}  // namespace
}  // namespace felt::haply::web_socket_test
