#pragma once

#include <sys/types.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

namespace felt {

/// A small process that releases a device without a watchdog if our program cannot do so, because
/// it was killed, has crashed, is stopped (Ctrl-Z, a debugger) or is unresponsive.
///
/// The guard holds a copy of the port and one end of a connection to our program. If a beat does
/// not arrive within the patience, it writes the last words once, and again only after new beats
/// and another silence. When the connection ends, which happens however our program ends, it writes
/// the last words and exits. It has a session of its own, receives only SIGKILL, keeps no other
/// file of ours open, and calls only functions that are safe after a fork of a program with
/// threads. Its memory is shared with ours until we write to it, so start the guard before the loop
/// runs.
class PortGuard {
 public:
  static constexpr std::size_t kMaxBytes = 64;

  /// Starts a guard. The caller still owns `port`. Returns null if `last_words` are longer than
  /// kMaxBytes, or if a process or connection cannot be created. Used on the edit thread.
  static std::unique_ptr<PortGuard> start(int port, std::span<const std::byte> last_words,
                                          std::int64_t patience_ns);
  /// Ends the guard, which then writes the last words. Waits until it has exited and the port is
  /// free.
  ~PortGuard();
  PortGuard(const PortGuard&) = delete;
  PortGuard& operator=(const PortGuard&) = delete;

  /// Sends a heartbeat. Returns false if the guard has ended (it was killed) and no longer protects
  /// the device. Safe to call from any thread. Real-time safe, because it makes only one transfer,
  /// which never waits.
  bool beat() noexcept;

 private:
  PortGuard(pid_t process, int connection) noexcept : process_(process), connection_(connection) {}

  pid_t process_;
  int connection_;
};

}  // namespace felt
