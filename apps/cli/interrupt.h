#pragma once

#include <cstdint>

namespace felt::cli {

/// What Ctrl-Z (SIGTSTP) asks for while an Interrupt lives: a device without a watchdog keeps its
/// last torque for as long as we are stopped.
enum class OnSuspend : std::uint8_t {
  kEnd,    ///< an end, as Ctrl-C does
  kPause,  ///< wants_pause(): whoever looks takes the forces away and calls pause()
};

/// While one lives, Ctrl-C (and Ctrl-backslash, a polite kill, a terminal that goes) asks for an
/// end instead of ending us: forces are taken away and what there is is kept. The second one, 0.3 s
/// later or more, ends us as ever. Reading or writing a terminal from the background fails instead
/// of stopping us.
class Interrupt {
 public:
  explicit Interrupt(OnSuspend on_suspend = OnSuspend::kEnd);
  Interrupt(const Interrupt&) = delete;
  Interrupt& operator=(const Interrupt&) = delete;
  ~Interrupt();

  [[nodiscard]] static bool was_asked() noexcept;
  [[nodiscard]] static bool wants_pause() noexcept;
  /// Stops the program; returns when it goes on (SIGCONT).
  static void pause() noexcept;
};

}  // namespace felt::cli
