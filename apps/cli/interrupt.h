#pragma once

#include <cstdint>

namespace felt::cli {

/// The reaction to Ctrl-Z (SIGTSTP) while an Interrupt exists. The program is not simply suspended,
/// because a device without a watchdog would then keep its last torque.
enum class OnSuspend : std::uint8_t {
  kEnd,    ///< requests the end of the program, like Ctrl-C
  kPause,  ///< sets wants_pause(); the caller then switches forces off and calls pause()
};

/// While an Interrupt exists, Ctrl-C (and Ctrl-backslash, SIGTERM, a closed terminal) does not end
/// the program but requests its end, so that the program can switch forces off and keep results. A
/// second Ctrl-C at least 0.3 s after the first ends the program as usual. If the program runs in
/// the background of a terminal, reading from or writing to the terminal fails instead of
/// suspending the program.
class Interrupt {
 public:
  explicit Interrupt(OnSuspend on_suspend = OnSuspend::kEnd);
  Interrupt(const Interrupt&) = delete;
  Interrupt& operator=(const Interrupt&) = delete;
  ~Interrupt();

  [[nodiscard]] static bool was_asked() noexcept;
  [[nodiscard]] static bool wants_pause() noexcept;
  /// Suspends the program. Returns when the program continues (SIGCONT).
  static void pause() noexcept;
};

}  // namespace felt::cli
