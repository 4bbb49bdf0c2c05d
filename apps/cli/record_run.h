#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "console.h"
#include "felt/session/session.h"
#include "forces_csv.h"
#include "live_loop.h"

namespace felt::cli {

struct RecordOptions {
  Rect page;
  double force_limit_n = 3.0;
  bool forces = false;
  bool asks = true;               ///< a person before an arm moves
  std::optional<double> seconds;  ///< how long; none: until somebody ends it
  std::function<bool()> is_over = {};
  /// Somebody wants the program to be stopped for a while; `pause` does it, once no force is left.
  std::function<bool()> wants_pause = {};
  std::function<void()> pause = {};
  /// They agreed to forces already; else the first Enter shows `consent`, the second one agrees.
  bool has_agreed = false;
  std::string consent = {};
  std::function<bool()> enter_pressed = {};  ///< since the last look; none: the terminal's
  /// Each turn: keeps a copy of the drawing where a crash leaves it.
  std::function<void(const Session&)> keep = {};
};

/// A drawing session with a real device, live: the edit side of the loop (architecture section 4,
/// steps 6 to 8) without a window. When the device fails, what was drawn stays, and the session
/// goes on with it once it is connected again, without forces until somebody allows them again.
class RecordRun {
 public:
  /// All must outlive it; `forces` may be null.
  RecordRun(const RealDevice& device, Session& session, Console& console, ForcesCsv* forces,
            RecordOptions options);

  /// Opens the device: before the first event, since it says what pushes back.
  Result<void> begin();
  /// Draws until the end. Error: the device hangs, or a file cannot be written; the session has all
  /// ink so far in any case.
  Result<void> draw();
  /// The device hung and was given up with its loop: its driver may not be used any more, nor
  /// destroyed, and the program should end without what libraries do at the end.
  [[nodiscard]] bool hangs() const noexcept { return hangs_; }

 private:
  using Clock = std::chrono::steady_clock;

  Result<void> turn();
  Result<void> note_forces(const TickReport& report);
  void tell_faults(const TickReport& report);
  void tell_status(const TickReport& report);
  void listen_to_keys();
  void end_loop();
  Result<void> pause();
  Result<void> reconnect(const std::string& why);
  bool tries_again(std::optional<Error>& refusal);
  [[nodiscard]] bool is_back() const;
  [[nodiscard]] bool is_enter_pressed() const;
  [[nodiscard]] std::int64_t elapsed_ns() const;
  [[nodiscard]] bool is_over() const;

  const RealDevice& device_;
  Session& session_;
  Console& console_;
  ForcesCsv* forces_csv_;
  RecordOptions options_;
  std::unique_ptr<LiveLoop> loop_;
  Clock::time_point start_ = Clock::now();
  std::int64_t offset_ns_ = 0;  // of the loop's clock in the session's
  std::int64_t last_ns_ = 0;    // of the session
  std::int64_t last_forces_ns_ = -1;
  std::uint32_t told_faults_ = 0;  // of this loop
  std::uint32_t told_cuts_ = 0;    // same
  std::optional<DeviceFault> told_device_fault_;
  std::optional<ShortText> told_notice_;
  bool wants_forces_ = false;
  bool has_agreed_ = false;
  bool hangs_ = false;
};

}  // namespace felt::cli
