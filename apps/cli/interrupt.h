#pragma once

#include <cstdint>

namespace felt::cli {

/// What Ctrl-Z (SIGTSTP) requests while an Interrupt exists. A device without a watchdog would keep
/// its last torque while the program is suspended.
enum class OnSuspend : std::uint8_t {
  kEnd,    ///< the end of the program, like Ctrl-C
  kPause,  ///< wants_pause(): the caller switches forces off and calls pause()
};

/// While an Interrupt exists, Ctrl-C (and Ctrl-backslash, SIGTERM, a closed terminal) requests an
/// end instead of ending the program, so that forces are switched off and results are kept. A
/// second one, at least 0.3 s later, ends the program as usual. Reading or writing a terminal from
/// the background fails instead of suspending the program.
class Interrupt {
 public:
  explicit Interrupt(OnSuspend on_suspend = OnSuspend::kEnd);
  Interrupt(const Interrupt&) = delete;
  Interrupt& operator=(const Interrupt&) = delete;
  ~Interrupt();

  [[nodiscard]] static bool was_asked() noexcept;
  [[nodiscard]] static bool wants_pause() noexcept;
  /// Suspends the program; returns when it continues (SIGCONT).
  static void pause() noexcept;
};

}  // namespace felt::cli
