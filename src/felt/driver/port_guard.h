#pragma once

#include <sys/types.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

namespace felt {

/// A small process that releases a device without a watchdog when our program cannot: killed,
/// crashed, stopped (Ctrl-Z, a debugger) or unresponsive.
///
/// It holds a copy of the port and one end of a connection to us. If no beat arrives for the
/// patience, it writes the last words once, and again only after new beats and another silence.
/// When the connection ends, which the system ensures however our program ends, it writes them and
/// exits. It has a session of its own, receives no signal but SIGKILL, keeps nothing else of ours
/// open, and calls only functions that are safe after a fork of a program with threads. Its memory
/// is shared with ours until we write to it: start it before the loop runs.
class PortGuard {
 public:
  static constexpr std::size_t kMaxBytes = 64;

  /// Starts a guard. The caller keeps `port`. Returns null if `last_words` are longer than
  /// kMaxBytes, or no process or connection can be created. Used on the edit thread.
  static std::unique_ptr<PortGuard> start(int port, std::span<const std::byte> last_words,
                                          std::int64_t patience_ns);
  /// Ends the guard, which writes the last words, and waits until it has exited and the port is
  /// free.
  ~PortGuard();
  PortGuard(const PortGuard&) = delete;
  PortGuard& operator=(const PortGuard&) = delete;

  /// Sends a sign of life. Returns false if the guard has ended (it was killed) and protects
  /// nothing any more. Safe to call from any thread; real-time safe: one transfer that never waits.
  bool beat() noexcept;

 private:
  PortGuard(pid_t process, int connection) noexcept : process_(process), connection_(connection) {}

  pid_t process_;
  int connection_;
};

}  // namespace felt
