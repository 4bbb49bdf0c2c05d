#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <tl/expected.hpp>

#include "felt/base/result.h"
#include "felt/driver/port_guard.h"

namespace felt {

/// Why a transfer failed. An enumeration, because the haptic thread must not allocate strings.
enum class StreamFault : std::uint8_t {
  kTimedOut,  ///< the time is over; nothing was lost, and the caller may retry
  kClosed,    ///< the peer closed the stream, or the device was unplugged
  kFailed,    ///< the system refused, see last_errno(); or only a part was sent
};

/// A byte stream to a device or its service that is used on the haptic thread: a socket, a serial
/// port, or in tests a fake without thread or clock.
///
/// send() and receive() block for at most the given time, and neither allocate nor throw. After
/// kClosed or kFailed the stream is unusable: every call returns the same fault. The destructor
/// closes it.
class ByteStream {
 public:
  ByteStream() = default;
  ByteStream(const ByteStream&) = delete;
  ByteStream& operator=(const ByteStream&) = delete;
  virtual ~ByteStream() = default;

  /// Sends all bytes within `within_ns` (0: only if they can be sent without waiting). kTimedOut:
  /// nothing was sent.
  virtual tl::expected<void, StreamFault> send(std::span<const std::byte> bytes,
                                               std::int64_t within_ns) noexcept = 0;
  /// Receives between 1 and `room.size()` bytes. 0 ns does not wait. Waits for the first byte only:
  /// a caller that needs more calls again with the time that is left (StreamDeadline).
  virtual tl::expected<std::size_t, StreamFault> receive(std::span<std::byte> room,
                                                         std::int64_t within_ns) noexcept = 0;
  /// Returns the errno of the newest kFailed, or 0 if no call has failed.
  [[nodiscard]] virtual int last_errno() const noexcept { return 0; }
  /// Starts a process (PortGuard) that sends `last_words` when nothing has been sent for
  /// `patience_ns`, or when this program ends for any reason. Replaces an earlier guard, which
  /// sends its own words as it ends; empty words only end that one. Returns false if no guard runs.
  /// Used on the edit thread.
  virtual bool keep_guard(std::span<const std::byte> last_words, std::int64_t patience_ns) {
    static_cast<void>(last_words);
    static_cast<void>(patience_ns);
    return false;
  }
  /// Returns false if the guard of keep_guard() has ended unexpectedly. This is detected by the
  /// next send(). The sender's thread.
  [[nodiscard]] virtual bool is_guarded() const noexcept { return true; }
};

/// Measures how much of a time limit is left, on the system's monotonic clock, so that several
/// calls can share one limit.
class StreamDeadline {
 public:
  explicit StreamDeadline(std::int64_t within_ns) noexcept;
  /// Returns 0 when the time is over, and always if the limit was 0.
  [[nodiscard]] std::int64_t left_ns() const noexcept;

 private:
  std::int64_t until_ns_;
};

/// A stream over a non-blocking file descriptor that it owns.
class DescriptorStream : public ByteStream {
 public:
  ~DescriptorStream() override;
  tl::expected<void, StreamFault> send(std::span<const std::byte> bytes,
                                       std::int64_t within_ns) noexcept override;
  tl::expected<std::size_t, StreamFault> receive(std::span<std::byte> room,
                                                 std::int64_t within_ns) noexcept override;
  [[nodiscard]] int last_errno() const noexcept override { return errno_; }

 protected:
  /// Takes ownership of `descriptor`. `is_socket`: write() would raise SIGPIPE.
  DescriptorStream(int descriptor, bool is_socket) noexcept
      : descriptor_(descriptor), is_socket_(is_socket) {}
  [[nodiscard]] int descriptor() const noexcept { return descriptor_; }

 private:
  tl::unexpected<StreamFault> end(StreamFault fault, int error) noexcept;

  int descriptor_;
  bool is_socket_;
  bool is_over_ = false;
  StreamFault fault_ = StreamFault::kClosed;  // if is_over_
  int errno_ = 0;
};

/// A TCP connection with Nagle's algorithm disabled.
class TcpStream final : public DescriptorStream {
 public:
  /// Connects, on the edit thread. `host` is "localhost" (IPv4 first, then IPv6) or a numeric
  /// address; names are not looked up, because that could block for a minute. Fails with the
  /// system's message.
  static Result<std::unique_ptr<ByteStream>> connect(const std::string& host, std::uint16_t port,
                                                     std::int64_t within_ns);

 private:
  using DescriptorStream::DescriptorStream;
};

/// A serial port in raw mode, locked against other programs. Opening it discards bytes that were
/// waiting.
class SerialStream final : public DescriptorStream {
 public:
  /// Opens a port, on the edit thread. Fails if it does not exist, is in use by another program, is
  /// not a serial port, or access is denied; with the system's message.
  static Result<std::unique_ptr<ByteStream>> open(const std::string& path);

  tl::expected<void, StreamFault> send(std::span<const std::byte> bytes,
                                       std::int64_t within_ns) noexcept override;
  bool keep_guard(std::span<const std::byte> last_words, std::int64_t patience_ns) override;
  [[nodiscard]] bool is_guarded() const noexcept override { return is_guarded_; }

 private:
  using DescriptorStream::DescriptorStream;

  std::unique_ptr<PortGuard> guard_;
  bool is_guarded_ = true;
};

/// How a driver connects to a service; tests pass a fake.
using TcpConnect = std::function<Result<std::unique_ptr<ByteStream>>(
    const std::string& host, std::uint16_t port, std::int64_t within_ns)>;
/// How a driver opens a serial port.
using SerialOpen = std::function<Result<std::unique_ptr<ByteStream>>(const std::string& path)>;

}  // namespace felt
