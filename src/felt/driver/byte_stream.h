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

/// Why a transfer failed. This is an enumeration, because the haptic thread must not allocate
/// strings.
enum class StreamFault : std::uint8_t {
  kTimedOut,  ///< the time limit passed; no bytes were lost, and the caller may retry
  kClosed,    ///< the peer closed the stream, or the device was unplugged
  kFailed,    ///< the system reported an error (last_errno()), or sent only a part of the bytes
};

/// A byte stream to a device or to the service of its maker, for use on the haptic thread. It is a
/// socket or a serial port; tests use a fake that has neither a thread nor a clock.
///
/// send() and receive() block for at most the given time, and neither allocate nor throw. After
/// kClosed or kFailed the stream is unusable: every call returns the same fault. The destructor
/// closes the stream.
class ByteStream {
 public:
  ByteStream() = default;
  ByteStream(const ByteStream&) = delete;
  ByteStream& operator=(const ByteStream&) = delete;
  virtual ~ByteStream() = default;

  /// Sends all bytes within `within_ns`. If `within_ns` is 0, sends them only if that is possible
  /// without waiting. Fails with kTimedOut if nothing was sent.
  virtual tl::expected<void, StreamFault> send(std::span<const std::byte> bytes,
                                               std::int64_t within_ns) noexcept = 0;
  /// Receives between 1 and `room.size()` bytes. Waits for the first byte only, and not at all if
  /// `within_ns` is 0. A caller that needs more bytes calls receive() again with the remaining time
  /// (StreamDeadline).
  virtual tl::expected<std::size_t, StreamFault> receive(std::span<std::byte> room,
                                                         std::int64_t within_ns) noexcept = 0;
  /// Returns the errno of the newest kFailed, or 0 if no call has failed.
  [[nodiscard]] virtual int last_errno() const noexcept { return 0; }
  /// Starts a guard process (PortGuard) that sends `last_words` if nothing has been sent for
  /// `patience_ns`, or if this program ends for any reason. If a guard already runs, ends it first;
  /// that guard then sends its own last words. If `last_words` is empty, no new guard is started.
  /// Returns true if a guard runs now. Used on the edit thread.
  virtual bool keep_guard(std::span<const std::byte> last_words, std::int64_t patience_ns) {
    static_cast<void>(last_words);
    static_cast<void>(patience_ns);
    return false;
  }
  /// Sends the guard a sign of life, as send() does for a serial port, but sends no bytes to the
  /// device. Only for a connection that its guard alone uses (TcpStream). Real-time safe; used on
  /// the thread that calls send().
  virtual void beat() noexcept {}
  /// Makes the guard of such a connection send its last words now. Real-time safe; any thread.
  virtual void let_guard_speak() noexcept {}
  /// Makes it wait for the next beat() without acting, unless this program ends. Real-time safe.
  virtual void let_guard_rest() noexcept {}
  /// Returns false if send() or beat() has found that the guard of keep_guard() ended unexpectedly.
  /// Used on the thread that calls send().
  [[nodiscard]] virtual bool is_guarded() const noexcept { return true; }
};

/// Measures how much of a time limit is left, on the system's monotonic clock. Several calls can
/// share one limit.
class StreamDeadline {
 public:
  explicit StreamDeadline(std::int64_t within_ns) noexcept;
  /// Returns 0 when the time is over, and always if the limit was 0.
  [[nodiscard]] std::int64_t left_ns() const noexcept;

 private:
  std::int64_t until_ns_;
};

/// A stream that owns a non-blocking file descriptor and transfers its bytes through it.
class DescriptorStream : public ByteStream {
 public:
  ~DescriptorStream() override;
  tl::expected<void, StreamFault> send(std::span<const std::byte> bytes,
                                       std::int64_t within_ns) noexcept override;
  tl::expected<std::size_t, StreamFault> receive(std::span<std::byte> room,
                                                 std::int64_t within_ns) noexcept override;
  [[nodiscard]] int last_errno() const noexcept override { return errno_; }

 protected:
  /// Takes ownership of `descriptor`. `is_socket` is true if write() would raise SIGPIPE.
  DescriptorStream(int descriptor, bool is_socket) noexcept
      : descriptor_(descriptor), is_socket_(is_socket) {}
  [[nodiscard]] int descriptor() const noexcept { return descriptor_; }

 private:
  tl::unexpected<StreamFault> end(StreamFault fault, int error) noexcept;

  int descriptor_;
  bool is_socket_;
  bool is_over_ = false;
  StreamFault fault_ = StreamFault::kClosed;  // valid if is_over_
  int errno_ = 0;
};

/// A stream that can have a guard.
class GuardedStream : public DescriptorStream {
 public:
  bool keep_guard(std::span<const std::byte> last_words, std::int64_t patience_ns) override;
  void beat() noexcept override;
  void let_guard_speak() noexcept override {
    if (guard_) guard_->speak();
  }
  void let_guard_rest() noexcept override {
    if (guard_) guard_->rest();
  }
  [[nodiscard]] bool is_guarded() const noexcept override { return is_guarded_; }

 protected:
  GuardedStream(int descriptor, bool is_socket, PortGuard::Use use) noexcept
      : DescriptorStream(descriptor, is_socket), use_(use) {}

 private:
  PortGuard::Use use_;
  std::unique_ptr<PortGuard> guard_;
  bool is_guarded_ = true;
};

/// A TCP connection with Nagle's algorithm disabled. If it has a guard, only the guard may use the
/// connection: the program sends nothing but signs of life (beat()).
class TcpStream final : public GuardedStream {
 public:
  /// Connects to a port. `host` is "localhost" (IPv4 first, then IPv6) or a numeric address; other
  /// names are not looked up, because that could block for a minute. Fails with the system's
  /// message. Used on the edit thread.
  static Result<std::unique_ptr<ByteStream>> connect(const std::string& host, std::uint16_t port,
                                                     std::int64_t within_ns);

 private:
  explicit TcpStream(int descriptor) noexcept
      : GuardedStream(descriptor, true, PortGuard::Use::kOwnConnection) {}
};

/// A serial port in raw mode, locked against other programs. Opening it discards bytes that were
/// waiting. Each successful send() is also a sign of life for the guard.
class SerialStream final : public GuardedStream {
 public:
  /// Opens a port. Fails with the system's message if the port does not exist, is not a serial port
  /// or is in use by another program, or if access is denied. Used on the edit thread.
  static Result<std::unique_ptr<ByteStream>> open(const std::string& path);

  tl::expected<void, StreamFault> send(std::span<const std::byte> bytes,
                                       std::int64_t within_ns) noexcept override;

 private:
  explicit SerialStream(int descriptor) noexcept
      : GuardedStream(descriptor, false, PortGuard::Use::kShared) {}
};

/// The function with which a driver connects to a service; tests pass a fake.
using TcpConnect = std::function<Result<std::unique_ptr<ByteStream>>(
    const std::string& host, std::uint16_t port, std::int64_t within_ns)>;
/// The function with which a driver opens a serial port; tests pass a fake.
using SerialOpen = std::function<Result<std::unique_ptr<ByteStream>>(const std::string& path)>;

}  // namespace felt
