#pragma once

#include <sys/types.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

namespace felt {

/// A small process that lets go of a device which has no watchdog of its own, when our program
/// cannot: killed, crashed, stopped (Ctrl-Z, a debugger) or hung.
///
/// It holds a copy of the port and one end of a connection to us. When beats stop for the patience,
/// it writes the last words once, until beats come again; when the connection ends, which the
/// system sees to however we end, it writes them and ends too. It has a session of its own and
/// hears no signal but SIGKILL, holds nothing else of ours open, and runs only what is safe after a
/// fork of a program with threads. While it lives it shares our memory until we write to it: start
/// it before the loop runs.
class PortGuard {
 public:
  static constexpr std::size_t kMostBytes = 64;

  /// Edit thread. `port` stays the caller's. Null: `last_words` are too many, or there is no
  /// process or connection to be had.
  static std::unique_ptr<PortGuard> start(int port, std::span<const std::byte> last_words,
                                          std::int64_t patience_ns);
  /// Ends it, with the last words, and waits until it has ended and the port is free.
  ~PortGuard();
  PortGuard(const PortGuard&) = delete;
  PortGuard& operator=(const PortGuard&) = delete;

  /// We live. Any thread; real-time safe: one transfer that never waits. False: the guard has ended
  /// (somebody killed it), and nothing guards any more.
  bool beat() noexcept;

 private:
  PortGuard(pid_t process, int connection) noexcept : process_(process), connection_(connection) {}

  pid_t process_;
  int connection_;
};

}  // namespace felt
