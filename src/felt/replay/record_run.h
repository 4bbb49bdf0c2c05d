#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "felt/replay/live_loop.h"
#include "felt/session/session.h"

namespace felt {

/// Status of a recording in progress.
struct RecordStatus {
  double rate_hz = 0.0;  ///< rate of the loop
  double sent_n = 0.0;
  SafetyState state{};
  std::size_t strokes = 0;
  bool wants_forces = false;
};

/// Options of a recording. Functions may be null.
struct RecordOptions {
  Rect page;
  double force_limit_n = 3.0;
  bool forces = false;
  std::optional<double> seconds = {};  ///< duration; if empty, until `is_over` returns true
  std::function<bool()> is_over = {};
  /// Returns true if the program should be suspended. `pause` suspends it after the force is zero.
  std::function<bool()> wants_pause = {};
  std::function<void()> pause = {};
  LiveLoop::MayMove may_move = {};
  /// True if the user has already agreed to forces. Otherwise the first press of Enter calls
  /// `ask_consent`, and the second press means that the user agrees.
  bool has_agreed = false;
  std::function<void()> ask_consent = {};
  /// Returns true if Enter was pressed since the last call.
  std::function<bool()> enter_pressed = {};
  std::function<void(const std::string&)> on_notice = {};
  std::function<void(const RecordStatus&)> on_status = {};  ///< every 4 ms
  /// Receives reports of the loop, about 250 per second, with their times in session time.
  std::function<Result<void>(const TickReport&)> on_tick = {};
  /// Called every 4 ms, for example to save a copy of the drawing (RecordCopy).
  std::function<void(const Session&)> keep = {};
};

/// A live drawing session with a real device and without a window. It does the work of the edit
/// thread: passes samples to the session, and publishes the session's force to the loop. If the
/// device fails, the ink is kept. The session continues when the device is connected again; forces
/// stay off until the user allows them again.
///
/// Pressing Enter switches forces off and on; a notice confirms the change.
class RecordRun {
 public:
  /// Requires that device and session outlive it.
  RecordRun(const RealDevice& device, Session& session, RecordOptions options);

  /// Opens the device. Call it before the first event, because it informs the session of the
  /// device's capabilities.
  Result<void> begin();
  /// Runs the session until the end of the recording. Fails if the device becomes unresponsive, or
  /// if `on_tick` fails. In any case, the session keeps all ink drawn so far.
  Result<void> draw();
  /// Returns true if the device became unresponsive and was abandoned with its loop. In that case
  /// do not use or destroy its driver, and exit the program without running the exit handlers of
  /// libraries.
  [[nodiscard]] bool hangs() const noexcept { return hangs_; }

 private:
  using Clock = std::chrono::steady_clock;

  Result<void> turn();
  Result<void> report_tick(const TickReport& report);
  void notice(const std::string& words) const;
  void report_faults(const TickReport& report);
  void report_status(const TickReport& report) const;
  void handle_enter();
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
  RecordOptions options_;
  std::unique_ptr<LiveLoop> loop_;
  Clock::time_point start_ = Clock::now();
  std::int64_t offset_ns_ = 0;  // session time minus loop time
  std::int64_t last_ns_ = 0;    // latest time of the session
  std::int64_t last_tick_ns_ = -1;
  std::uint32_t reported_faults_ = 0;  // faults of this loop that were reported
  std::uint32_t reported_cuts_ = 0;    // cuts of this loop that were reported
  std::optional<DeviceFault> reported_device_fault_;
  std::optional<ShortText> reported_notice_;
  bool wants_forces_ = false;
  bool has_agreed_ = false;
  bool hangs_ = false;
};

}  // namespace felt
