#include "felt/devices/haply/web_socket.h"

#include <algorithm>
#include <cstring>
#include <optional>
#include <span>

#include "felt/devices/haply/web_socket_key.h"

namespace felt::haply {
namespace {

// Opcodes and bits of a frame (RFC 6455, section 5.2).
constexpr std::uint8_t kContinuation = 0x0, kText = 0x1, kClose = 0x8, kPing = 0x9, kPong = 0xA;
constexpr std::uint8_t kLastBit = 0x80, kReservedBits = 0x70, kOpcodeBits = 0x0F;
constexpr std::uint8_t kMaskBit = 0x80, kLengthBits = 0x7F;
constexpr std::uint8_t kLength16 = 126, kLength64 = 127;
constexpr std::size_t kMaxControl = 125;
constexpr std::int64_t kControlNs = 100'000;    // time limit for sending a pong or a close frame
constexpr std::size_t kMaxOpeningBytes = 8192;  // limit of the server's handshake

std::uint8_t byte_of(char c) noexcept {
  return static_cast<std::uint8_t>(c);
}

bool same_word(std::string_view a, std::string_view b) {
  const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; };
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [&](char x, char y) { return lower(x) == lower(y); });
}

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) text.remove_prefix(1);
  while (!text.empty() && (text.back() == ' ' || text.back() == '\t')) text.remove_suffix(1);
  return text;
}

// Returns the value of a header line of an HTTP answer.
std::optional<std::string_view> header_of(std::string_view answer, std::string_view name) {
  std::size_t at = answer.find("\r\n");
  while (at != std::string_view::npos && at + 2 < answer.size()) {
    at += 2;
    const std::size_t end = std::min(answer.find("\r\n", at), answer.size());
    const std::string_view line = answer.substr(at, end - at);
    const std::size_t colon = line.find(':');
    if (colon != std::string_view::npos && same_word(line.substr(0, colon), name)) {
      return trimmed(line.substr(colon + 1));
    }
    at = answer.find("\r\n", at);
  }
  return std::nullopt;
}

}  // namespace

WebSocket::WebSocket(std::unique_ptr<ByteStream> stream, std::uint64_t seed) noexcept
    : stream_(std::move(stream)), random_(seed | 1u) {}

std::uint64_t WebSocket::random() noexcept {  // xorshift64*, Vigna 2016
  random_ ^= random_ >> 12;
  random_ ^= random_ << 25;
  random_ ^= random_ >> 27;
  return random_ * 0x2545F4914F6CDD1Du;
}

Result<std::unique_ptr<WebSocket>> WebSocket::open(std::unique_ptr<ByteStream> stream,
                                                   const std::string& host, std::uint64_t seed,
                                                   std::int64_t within_ns) {
  auto socket = std::make_unique<WebSocket>(std::move(stream), seed);
  if (auto shaken = socket->shake_hands(host, within_ns); !shaken) {
    return tl::unexpected(shaken.error());
  }
  return socket;
}

Result<void> WebSocket::shake_hands(const std::string& host, std::int64_t within_ns) {
  std::array<std::byte, 16> nonce{};
  for (std::size_t i = 0; i < nonce.size(); ++i) nonce[i] = static_cast<std::byte>(random() >> 56);
  const std::string key = base64(nonce);
  const std::string request = "GET / HTTP/1.1\r\nHost: " + host +
                              "\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
                              "Sec-WebSocket-Key: " +
                              key + "\r\nSec-WebSocket-Version: 13\r\n\r\n";
  const auto bytes = std::as_bytes(std::span(request.data(), request.size()));
  if (!stream_->send(bytes, within_ns)) {
    return fail(ErrorCode::kIo, host + ": the connection was closed");
  }
  const Result<std::size_t> size = take_answer(within_ns);
  if (!size) return tl::unexpected(with_context(size.error(), host));
  const std::string_view answer(received_.data(), *size);
  const std::string first(answer.substr(0, answer.find("\r\n")));
  if (!first.starts_with("HTTP/1.1 101")) {
    return fail(ErrorCode::kInvalidData,
                host + ": not a WebSocket server; it answered \"" + first + "\"");
  }
  const auto upgrade = header_of(answer, "Upgrade"),
             accept = header_of(answer, "Sec-WebSocket-Accept");
  if (!upgrade || !same_word(*upgrade, "websocket") || !accept || *accept != accept_for(key)) {
    return fail(ErrorCode::kInvalidData, host + ": invalid answer to the WebSocket handshake");
  }
  begin_ = *size;
  return {};
}

// Reads the HTTP answer. Returns its size including the empty line at its end. Bytes that follow it
// stay in the buffer for receive().
Result<std::size_t> WebSocket::take_answer(std::int64_t within_ns) {
  const StreamDeadline deadline(within_ns);
  for (;;) {
    const std::string_view so_far(received_.data(), end_);
    const std::size_t end = so_far.find("\r\n\r\n");
    if (end != std::string_view::npos) return end + 4;
    if (so_far.size() > kMaxOpeningBytes) {
      return fail(ErrorCode::kLimitExceeded, "the answer to the handshake is too long");
    }
    if (!fill(deadline.left_ns())) {
      return fail(ErrorCode::kIo, is_over_ ? "the connection was closed" : "no answer");
    }
  }
}

WebSocket::Step WebSocket::end(SocketFault fault) noexcept {
  is_over_ = true;
  fault_ = fault;
  return Step::kOver;
}

// Receives more bytes and appends them. Returns false if no bytes came in time, or if the stream
// ended.
bool WebSocket::fill(std::int64_t within_ns) noexcept {
  if (begin_ > 0) {
    std::memmove(received_.data(), received_.data() + begin_, end_ - begin_);
    end_ -= begin_;
    begin_ = 0;
  }
  const auto room = std::as_writable_bytes(std::span(received_)).subspan(end_);
  const auto count = stream_->receive(room, within_ns);
  if (count) {
    end_ += *count;
    return true;
  }
  if (count.error() != StreamFault::kTimedOut) end(SocketFault::kClosed);
  return false;
}

WebSocket::Look WebSocket::look(Frame& frame) const noexcept {
  const std::string_view bytes(received_.data() + begin_, end_ - begin_);
  if (bytes.size() < 2) return Look::kMore;
  const std::uint8_t first = byte_of(bytes[0]), second = byte_of(bytes[1]);
  // A server must not mask, and no extension was negotiated.
  if ((first & kReservedBits) != 0 || (second & kMaskBit) != 0) return Look::kBad;
  frame.opcode = first & kOpcodeBits;
  frame.is_last = (first & kLastBit) != 0;
  const std::uint8_t length = second & kLengthBits;
  const bool is_control = (frame.opcode & 0x8) != 0;
  if (is_control && (length > kMaxControl || !frame.is_last)) return Look::kBad;
  const std::size_t extra = length == kLength16 ? 2 : length == kLength64 ? 8 : 0;
  frame.header = 2 + extra;
  if (bytes.size() < frame.header) return Look::kMore;
  std::uint64_t size = extra == 0 ? length : 0;
  for (std::size_t i = 0; i < extra; ++i) size = (size << 8) | byte_of(bytes[2 + i]);
  if (size > kMaxBytes) return Look::kBad;
  frame.size = static_cast<std::size_t>(size);
  return bytes.size() < frame.header + frame.size ? Look::kMore : Look::kWhole;
}

WebSocket::Step WebSocket::take_control(const Frame& frame, std::string_view payload) noexcept {
  switch (frame.opcode) {
    case kPing:
      static_cast<void>(send_frame(kPong, payload, kControlNs));
      return Step::kNothing;
    case kPong:
      return Step::kNothing;
    case kClose:
      close();
      return end(SocketFault::kClosed);
    default:
      return end(SocketFault::kBadData);
  }
}

WebSocket::Step WebSocket::take_data(const Frame& frame, std::string_view payload) noexcept {
  const bool begins = frame.opcode == kText;
  if ((!begins && frame.opcode != kContinuation) || begins == in_fragments_) {
    return end(SocketFault::kBadData);
  }
  if (begins && frame.is_last) {
    message_ = payload;
    return Step::kMessage;
  }
  if (begins) assembled_ = 0;
  if (payload.size() > fragments_.size() - assembled_) return end(SocketFault::kBadData);
  std::copy(payload.begin(), payload.end(), fragments_.data() + assembled_);
  assembled_ += payload.size();
  in_fragments_ = !frame.is_last;
  if (in_fragments_) return Step::kNothing;
  message_ = {fragments_.data(), assembled_};
  return Step::kMessage;
}

WebSocket::Step WebSocket::take(const Frame& frame) noexcept {
  const std::string_view payload(received_.data() + begin_ + frame.header, frame.size);
  begin_ += frame.header + frame.size;
  return (frame.opcode & 0x8) != 0 ? take_control(frame, payload) : take_data(frame, payload);
}

tl::expected<std::string_view, SocketFault> WebSocket::receive(std::int64_t within_ns) noexcept {
  const StreamDeadline deadline(within_ns);
  for (int frames = 0; frames < kMaxFrames && !is_over_;) {
    Frame frame;
    switch (look(frame)) {
      case Look::kBad:
        end(SocketFault::kBadData);
        break;
      case Look::kMore:
        if (!fill(deadline.left_ns()) && !is_over_) return tl::unexpected(SocketFault::kTimedOut);
        break;
      case Look::kWhole:
        ++frames;
        if (take(frame) == Step::kMessage) return message_;
        break;
    }
  }
  return tl::unexpected(is_over_ ? fault_ : SocketFault::kTimedOut);
}

tl::expected<void, SocketFault> WebSocket::send_frame(std::uint8_t opcode, std::string_view payload,
                                                      std::int64_t within_ns) noexcept {
  std::array<char, kMaxSent + 8> frame;
  if (payload.size() > kMaxSent) return tl::unexpected(SocketFault::kBadData);
  std::size_t at = 0;
  frame[at++] = static_cast<char>(kLastBit | opcode);
  if (payload.size() < kLength16) {
    frame[at++] = static_cast<char>(kMaskBit | payload.size());
  } else {
    frame[at++] = static_cast<char>(kMaskBit | kLength16);
    frame[at++] = static_cast<char>(payload.size() >> 8);
    frame[at++] = static_cast<char>(payload.size() & 0xFF);
  }
  const std::uint64_t mask = random();
  std::array<std::uint8_t, 4> key{};
  for (std::size_t i = 0; i < key.size(); ++i) {
    key[i] = static_cast<std::uint8_t>(mask >> (56 - 8 * i));
    frame[at++] = static_cast<char>(key[i]);
  }
  for (std::size_t i = 0; i < payload.size(); ++i) {
    frame[at++] = static_cast<char>(byte_of(payload[i]) ^ key[i % 4]);
  }
  const auto sent = stream_->send(std::as_bytes(std::span(frame.data(), at)), within_ns);
  if (sent) return {};
  if (sent.error() == StreamFault::kTimedOut) return tl::unexpected(SocketFault::kTimedOut);
  end(SocketFault::kClosed);
  return tl::unexpected(SocketFault::kClosed);
}

tl::expected<void, SocketFault> WebSocket::send(std::string_view text,
                                                std::int64_t within_ns) noexcept {
  if (is_over_) return tl::unexpected(fault_);
  return send_frame(kText, text, within_ns);
}

void WebSocket::close() noexcept {
  if (said_goodbye_ || is_over_) return;
  said_goodbye_ = true;
  static_cast<void>(send_frame(kClose, std::string_view("\x03\xE8", 2), kControlNs));  // 1000
}

}  // namespace felt::haply
