#pragma once

#include <sys/types.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
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
  static constexpr std::int64_t kEndNs = 2'000'000'000;
  static constexpr std::int64_t kMaxUnreadNs = 50'000'000;

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
  /// closed the port. A guard that was stopped (SIGSTOP) is continued. If the guard has not exited
  /// after kEndNs, it is killed. This function writes the last words if the guard was killed, by it
  /// or before. So the caller must keep the port open until then.
  ~PortGuard();
  PortGuard(const PortGuard&) = delete;
  PortGuard& operator=(const PortGuard&) = delete;

  /// Sends a heartbeat. Returns false if the guard does not protect the device, because it has
  /// ended (it was killed) or does not run (it was stopped): heartbeats have been waiting for it
  /// for kMaxUnreadNs. Call it from one thread at a time. Real-time safe, because it makes only
  /// system calls that never wait.
  bool beat() noexcept;
  /// Makes the guard write the last words now, because our program cannot reach the device itself.
  /// The guard then waits for the next heartbeat. If the guard does not run, this function writes
  /// the words to the guard's port, without waiting. Real-time safe, like beat().
  void speak() noexcept;
  /// Makes the guard wait for the next heartbeat without acting, because no force is requested.
  /// If our program ends, the guard still writes the last words. Real-time safe, like beat().
  void rest() noexcept;

 private:
  /// What the guard and the program know of each other. The connection differs.
  struct Watch {
    int port = -1;
    int connection = -1;
    std::array<std::byte, kMaxBytes> words{};
    std::size_t size = 0;
    std::int64_t patience_ns = 0;
    Use use = Use::kShared;
  };
  struct Process;  // the functions of the guard process

  PortGuard(pid_t process, const Watch& watch) noexcept : process_(process), watch_(watch) {}
  bool send(char sign) noexcept;
  [[nodiscard]] std::optional<int> exit_status(std::int64_t within_ns) const noexcept;

  pid_t process_;
  Watch watch_;
  /// On the monotonic clock. 0 if the guard had read everything at the last heartbeat.
  std::int64_t unread_since_ns_ = 0;
  bool is_alive_ = true;  // at the last heartbeat
};

}  // namespace felt
