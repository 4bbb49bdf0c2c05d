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

/// Why bytes did not go or come. An enumeration, because the haptic thread must not make strings.
enum class StreamFault : std::uint8_t {
  kTimedOut,  ///< not within the time given; nothing was lost, and it may be tried again
  kClosed,    ///< the other side ended it, or was unplugged
  kFailed,    ///< the system refuses; last_errno() says why. Or a part went and the rest did not
};

/// A connection to a device or its service that is used on the haptic thread: bytes in order, each
/// way. What answers is a socket, a serial port, or in tests a fake without thread or clock.
///
/// send() and receive() block for their time at most, and neither allocate nor throw. After
/// kClosed or kFailed the stream is of no use: it says the same again. Closed by its destructor.
class ByteStream {
 public:
  ByteStream() = default;
  ByteStream(const ByteStream&) = delete;
  ByteStream& operator=(const ByteStream&) = delete;
  virtual ~ByteStream() = default;

  /// Sends all of it, within `within_ns` (0 = only what goes at once). kTimedOut: none of it went.
  virtual tl::expected<void, StreamFault> send(std::span<const std::byte> bytes,
                                               std::int64_t within_ns) noexcept = 0;
  /// What has come, at least one byte, at most `room`. 0 = does not wait. Waits for the first byte
  /// only, so that a caller who knows how much must come calls again with the time that is left.
  virtual tl::expected<std::size_t, StreamFault> receive(std::span<std::byte> room,
                                                         std::int64_t within_ns) noexcept = 0;
  /// errno of the newest kFailed; 0 = none.
  [[nodiscard]] virtual int last_errno() const noexcept { return 0; }
  /// From now on a process of its own sends `last_words` when nothing has been sent for so long, or
  /// when this program ends however (PortGuard). Edit thread. In the place of the one
  /// before, which then speaks; without words: none any more. False: there is none.
  virtual bool keep_guard(std::span<const std::byte> last_words, std::int64_t patience_ns) {
    static_cast<void>(last_words);
    static_cast<void>(patience_ns);
    return false;
  }
  /// False: the guard that keep_guard() had made has ended, though nobody asked it to. Known once
  /// something was sent after that. The sender's thread.
  [[nodiscard]] virtual bool is_guarded() const noexcept { return true; }
};

/// How much of a time is left, on the system's monotonic clock: for who receives several times.
class StreamDeadline {
 public:
  explicit StreamDeadline(std::int64_t within_ns) noexcept;
  /// 0 when it is over, and always for one of 0.
  [[nodiscard]] std::int64_t left_ns() const noexcept;

 private:
  std::int64_t until_ns_;
};

/// A stream over a file descriptor of our own that does not block.
class DescriptorStream : public ByteStream {
 public:
  ~DescriptorStream() override;
  tl::expected<void, StreamFault> send(std::span<const std::byte> bytes,
                                       std::int64_t within_ns) noexcept override;
  tl::expected<std::size_t, StreamFault> receive(std::span<std::byte> room,
                                                 std::int64_t within_ns) noexcept override;
  [[nodiscard]] int last_errno() const noexcept override { return errno_; }

 protected:
  /// Takes `descriptor` over. `is_socket`: write() would raise SIGPIPE.
  DescriptorStream(int descriptor, bool is_socket) noexcept
      : descriptor_(descriptor), is_socket_(is_socket) {}
  [[nodiscard]] int descriptor() const noexcept { return descriptor_; }

 private:
  tl::unexpected<StreamFault> end(StreamFault fault, int error) noexcept;

  int descriptor_;
  bool is_socket_;
  bool is_over_ = false;
  StreamFault fault_ = StreamFault::kClosed;  // while is_over_
  int errno_ = 0;
};

/// A TCP connection without Nagle's delay.
class TcpStream final : public DescriptorStream {
 public:
  /// Connects, on the edit thread. `host` is "localhost" (IPv4 first, then IPv6) or a number: no
  /// name is looked up, which could block for a minute. Error: the system's own words.
  static Result<std::unique_ptr<ByteStream>> connect(const std::string& host, std::uint16_t port,
                                                     std::int64_t within_ns);

 private:
  using DescriptorStream::DescriptorStream;
};

/// A serial port: raw bytes, locked against other programs, what waited in it thrown away.
class SerialStream final : public DescriptorStream {
 public:
  /// Opens on the edit thread. Error: there is none, another program has it, permission denied, or
  /// it is no serial port; with the system's words.
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

/// How a driver reaches a service; tests put a fake in its place.
using TcpConnect = std::function<Result<std::unique_ptr<ByteStream>>(
    const std::string& host, std::uint16_t port, std::int64_t within_ns)>;
/// How a driver opens a serial port.
using SerialOpen = std::function<Result<std::unique_ptr<ByteStream>>(const std::string& path)>;

}  // namespace felt
