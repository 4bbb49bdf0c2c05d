#pragma once

#include <sys/types.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

namespace felt {

/// A small process that sets the force of a device without a watchdog to zero when our program
/// cannot do so because it was killed, has crashed, is stopped (Ctrl-Z, a debugger) or is
/// unresponsive.
///
/// The guard holds a copy of the port and one end of a connection to our program. If the heartbeats
/// (see beat()) stop for `patience_ns`, the guard writes `last_words`, a message that releases the
/// force, to the port. It does so once for each interruption of the heartbeats. When the connection
/// ends, which happens however our program ends, the guard writes `last_words` and exits. The guard
/// runs in its own session, blocks all signals (only SIGKILL and SIGSTOP still reach it), closes
/// all other files of our program, and calls only functions that are safe after a fork of a program
/// with threads. After the fork, the kernel copies a page of memory when our program first writes
/// to it, which takes time; therefore start the guard before the loop runs.
class PortGuard {
 public:
  static constexpr std::size_t kMaxBytes = 64;

  /// Who uses the port besides the guard.
  enum class Use : std::uint8_t {
    kShared,  ///< our program sends and receives; the guard only sends
    /// A network connection that only the guard uses. The guard reads and discards the answers, so
    /// that the peer gets the last words even if it answered earlier ones. If the peer closes the
    /// connection, the guard ends, and beat() reports that.
    kOwnConnection,
  };

  /// Starts a guard. `port` is a file descriptor, which the caller still owns. Returns null if
  /// `last_words` are longer than kMaxBytes, or if a process or connection cannot be created. Used
  /// on the edit thread.
  static std::unique_ptr<PortGuard> start(int port, std::span<const std::byte> last_words,
                                          std::int64_t patience_ns, Use use = Use::kShared);
  /// Ends the guard, which then writes the last words. Waits until the guard has exited and has
  /// closed the port.
  ~PortGuard();
  PortGuard(const PortGuard&) = delete;
  PortGuard& operator=(const PortGuard&) = delete;

  /// Sends a heartbeat. Returns false if the guard has ended (it was killed) and no longer protects
  /// the device. Safe to call from any thread. Real-time safe, because it makes a single system
  /// call that never waits.
  bool beat() noexcept;
  /// Makes the guard write the last words now, because our program cannot reach the device itself.
  /// The guard then waits for the next heartbeat. Real-time safe, like beat().
  void speak() noexcept;
  /// Makes the guard wait for the next heartbeat without acting, because no force is requested.
  /// If our program ends, the guard still writes the last words. Real-time safe, like beat().
  void rest() noexcept;

 private:
  bool send(char sign) noexcept;
  PortGuard(pid_t process, int connection) noexcept : process_(process), connection_(connection) {}

  pid_t process_;
  int connection_;
};

}  // namespace felt
