#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <tl/expected.hpp>

#include "felt/base/result.h"
#include "felt/driver/byte_stream.h"

namespace felt::haply {

/// Why a message was not received or sent.
enum class SocketFault : std::uint8_t {
  kTimedOut,  ///< no whole message was transferred in time; the caller may retry
  kClosed,    ///< the peer closed the connection or has disappeared
  kBadData,   ///< not a WebSocket frame, or too long; the connection is unusable from then on
};

/// The client's end of a WebSocket (RFC 6455), for text messages only. This class does not allocate
/// after open(), and no call blocks longer than `within_ns`, because the haptic thread uses it to
/// send and receive one message each millisecond. The class joins fragments of a message, answers
/// pings, and rejects a message as soon as its announced length exceeds kMaxBytes. After a call has
/// failed with kClosed or kBadData, every later call fails with the same fault.
///
/// The object is large (two buffers of 64 KiB), so allocate it on the heap. For use by one thread
/// at a time.
class WebSocket {
 public:
  static constexpr std::size_t kMaxBytes = std::size_t{1} << 16;  ///< longest received message
  static constexpr std::size_t kMaxSent = 1024;
  static constexpr int kMaxFrames = 64;  ///< frames read by one receive()

  /// Performs the opening handshake over `stream`. `host` is the host of the address. The key and
  /// the masks are generated from `seed`, which must be unpredictable: RFC 6455 requires this to
  /// protect proxies.
  static Result<std::unique_ptr<WebSocket>> open(std::unique_ptr<ByteStream> stream,
                                                 const std::string& host, std::uint64_t seed,
                                                 std::int64_t within_ns);
  /// Uses a stream whose handshake has already been made. For tests.
  WebSocket(std::unique_ptr<ByteStream> stream, std::uint64_t seed) noexcept;

  /// Sends a text message of at most kMaxSent bytes.
  tl::expected<void, SocketFault> send(std::string_view text, std::int64_t within_ns) noexcept;
  /// Receives the next whole message. The returned text is valid until the next call.
  tl::expected<std::string_view, SocketFault> receive(std::int64_t within_ns) noexcept;
  /// Sends a close frame, once. Does not wait for the answer.
  void close() noexcept;

 private:
  struct Frame {
    std::uint8_t opcode = 0;
    bool is_last = false;
    std::size_t header = 0;
    std::size_t size = 0;
  };
  enum class Look : std::uint8_t { kWhole, kMore, kBad };
  enum class Step : std::uint8_t { kMessage, kNothing, kOver };

  Result<void> shake_hands(const std::string& host, std::int64_t within_ns);
  Result<std::size_t> take_answer(std::int64_t within_ns);
  [[nodiscard]] Look look(Frame& frame) const noexcept;
  Step take(const Frame& frame) noexcept;
  Step take_data(const Frame& frame, std::string_view payload) noexcept;
  Step take_control(const Frame& frame, std::string_view payload) noexcept;
  bool fill(std::int64_t within_ns) noexcept;
  tl::expected<void, SocketFault> send_frame(std::uint8_t opcode, std::string_view payload,
                                             std::int64_t within_ns) noexcept;
  Step end(SocketFault fault) noexcept;
  std::uint64_t random() noexcept;

  std::unique_ptr<ByteStream> stream_;
  std::uint64_t random_;
  bool is_over_ = false;
  bool said_goodbye_ = false;
  SocketFault fault_ = SocketFault::kClosed;  // valid if is_over_
  std::size_t begin_ = 0, end_ = 0;           // range of unread bytes in received_
  std::size_t assembled_ = 0;                 // bytes of a fragmented message
  bool in_fragments_ = false;
  std::string_view message_;
  static constexpr std::size_t kMaxHeader = 10;
  std::array<char, kMaxBytes + kMaxHeader> received_;
  std::array<char, kMaxBytes> fragments_;
};

}  // namespace felt::haply
