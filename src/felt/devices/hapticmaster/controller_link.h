#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string_view>
#include <tl/expected.hpp>

#include "felt/driver/byte_stream.h"

namespace felt::hapticmaster {

/// A request is a header of this size and ASCII text without a terminator. Bytes 0 to 3 of the
/// header are the length of the text, big-endian; the others are 0
/// (docs/design/devices.md#hapticmaster-protocol).
inline constexpr std::size_t kHeaderBytes = 8;
inline constexpr std::size_t kMaxRequest = 255;
inline constexpr std::size_t kMaxAnswer = 1024 - kHeaderBytes;

/// Writes a request into `room`. Returns its size, or 0 if the text is longer than kMaxRequest or
/// does not fit.
std::size_t write_request(std::string_view text, std::span<std::byte> room) noexcept;

/// Why an answer was not received or a request not sent.
enum class LinkFault : std::uint8_t {
  kTimedOut,  ///< no whole answer was transferred in time; the caller may retry
  kClosed,    ///< the controller closed the connection or has disappeared
  kBadData,   ///< an impossible length, or text that is not ASCII: answers cannot be told apart
};

/// Our end of a connection to the controller: sends requests and receives whole answers, in order.
/// The answers are assumed to have the same header as requests. Public clients discard the header
/// of an answer, so this is not known; the driver checks it when it opens the device. Bytes 4 to 7
/// are ignored.
///
/// Neither allocates nor blocks longer than `within_ns`. After a call has failed with kClosed or
/// kBadData, every later call fails with the same fault. For use by one thread at a time.
class ControllerLink {
 public:
  explicit ControllerLink(std::unique_ptr<ByteStream> stream) noexcept
      : stream_(std::move(stream)) {}

  tl::expected<void, LinkFault> send(std::string_view text, std::int64_t within_ns) noexcept;
  /// Receives the next answer, without quotation marks, semicolons and white space at both ends.
  /// The returned text is valid until the next call.
  tl::expected<std::string_view, LinkFault> receive(std::int64_t within_ns) noexcept;
  [[nodiscard]] int last_errno() const noexcept { return stream_->last_errno(); }

 private:
  static constexpr int kMaxPieces = 128;  // pieces in which one answer may arrive

  enum class Look : std::uint8_t { kWhole, kMore, kBad };
  Look look() noexcept;
  tl::unexpected<LinkFault> end(LinkFault fault) noexcept;

  std::unique_ptr<ByteStream> stream_;
  bool is_over_ = false;
  LinkFault fault_ = LinkFault::kClosed;  // valid if is_over_
  std::size_t begin_ = 0, end_ = 0;       // range of unread bytes in in_
  std::size_t size_ = 0;                  // of the text of the first answer, if it is whole
  std::array<std::byte, 2 * (kHeaderBytes + kMaxAnswer)> in_{};
};

}  // namespace felt::hapticmaster
