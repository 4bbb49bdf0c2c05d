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

/// Why a message did not come or go.
enum class SocketFault : std::uint8_t {
  kTimedOut,  ///< nothing whole within the time; try again
  kClosed,    ///< the other side ended it, or is gone
  kBadData,  ///< what came is no WebSocket frame, or too long; the connection is of no use any more
};

/// The client's end of a WebSocket (RFC 6455), text messages only, made for one message each way a
/// millisecond: fixed memory, no allocation after open(), nothing that blocks beyond its time.
/// Fragments are put together, pings answered, lengths beyond kMostBytes refused before anything is
/// believed of them. After kClosed or kBadData it says the same again.
///
/// Large (two buffers of 64 KiB): lives on the heap. One thread at a time.
class WebSocket {
 public:
  static constexpr std::size_t kMostBytes = std::size_t{1} << 16;  ///< of a message
  static constexpr std::size_t kMostSent = 1024;
  static constexpr int kMostFrames = 64;  ///< that one receive() looks at

  /// Asks the other side of `stream` to speak WebSocket. `host` as in the address. `seed` makes the
  /// key and the masks, which RFC 6455 wants unpredictable for the sake of proxies.
  static Result<std::unique_ptr<WebSocket>> open(std::unique_ptr<ByteStream> stream,
                                                 const std::string& host, std::uint64_t seed,
                                                 std::int64_t within_ns);
  /// Over a stream on which the opening is done already: for tests.
  WebSocket(std::unique_ptr<ByteStream> stream, std::uint64_t seed) noexcept;

  /// Sends a text message of at most kMostSent bytes.
  tl::expected<void, SocketFault> send(std::string_view text, std::int64_t within_ns) noexcept;
  /// The next whole message; valid until the next call.
  tl::expected<std::string_view, SocketFault> receive(std::int64_t within_ns) noexcept;
  /// Says good-bye, once. Does not wait for the answer.
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
  SocketFault fault_ = SocketFault::kClosed;  // while is_over_
  std::size_t begin_ = 0, end_ = 0;           // of what came and is not looked at, in received_
  std::size_t assembled_ = 0;                 // bytes of a message in fragments
  bool in_fragments_ = false;
  std::string_view message_;
  static constexpr std::size_t kMostHeader = 10;
  std::array<char, kMostBytes + kMostHeader> received_;
  std::array<char, kMostBytes> fragments_;
};

}  // namespace felt::haply
