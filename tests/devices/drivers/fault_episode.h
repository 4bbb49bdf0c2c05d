#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "felt/base/hash.h"
#include "felt/base/random.h"
#include "felt/rt/servo.h"
#include "felt/session/session.h"
#include "tests/devices/drivers/bench_device.h"
#include "tests/devices/drivers/fault_case.h"

namespace felt {

/// The result of a case, measured at the motors of the fake.
struct FaultVerdict {
  std::string broken{};  ///< empty: all rules were kept
  std::uint64_t ticks = 0;
  double force_before_n = 0.0;  ///< held when the fault happened
  /// Time until the force was zero. Has no value if the force may stay.
  std::optional<std::int64_t> zero_after_ns{};
  double force_after_n = 0.0;  ///< largest force after forces were engaged again
  bool reconnected = false;
  std::uint64_t digest = 0;  ///< of all poses, forces and the drawing
};

/// A short drawing session with all layers: a hand behind the fake, the driver's real code, the
/// loop and the safety chain, and a session with its tools. Forces engage, the pen touches down and
/// moves, a fault happens, the hand continues and lifts. Then the user repairs what is needed and
/// arms the forces, and the pen touches down again.
///
/// The rules, at each tick:
/// - the motors never hold a force above the limit of the device's row or one that is not a number;
///   the force grows by at most 0.3 N/ms, and by at most 0.01 N/ms while it engages
/// - a fault that takes the force away does so within its time limit, and no force returns until
///   the user has armed again
/// - samples that can still be read still reach the session
/// - kDisconnected is permanent
/// - the force that the tick reports as sent is the force that the fake received
/// The rules at the end: forces are back; every accepted sample is ink (pencil); undo restores the
/// first drawing; no rule of the vendor was broken.
class FaultEpisode {
 public:
  FaultEpisode(const BenchMaker& make, const FaultCase& fault);

  FaultVerdict run();

 private:
  enum class Phase { kBefore, kDuring, kAfter, kAgain };

  // fault_episode.cc: the course of the case.
  void new_loop();
  [[nodiscard]] Vec3 hand_at(std::int64_t script_ns) const;
  void move_hand();
  void turn();
  void begin_happening();
  void end_happening();
  void choose_other_tool();
  void try_too_early();
  void mend();
  void advance();
  [[nodiscard]] std::int64_t now() const noexcept { return script_ns_ + offset_ns_; }

  // fault_rules.cc: the rules.
  void broken(std::string rule);
  void check_tick(const TickReport& tick);
  void check_force(const TickReport& tick);
  void check_log(const TickReport& tick);
  void check_zero(const TickReport& tick);
  void check_reading(const TickReport& tick);
  void check_back();
  void check_end();
  void check_ink();
  [[nodiscard]] std::optional<std::int64_t> zero_within_ns() const;
  [[nodiscard]] std::optional<std::int64_t> zero_after_device_fault_ns() const;
  [[nodiscard]] bool is_hard() const noexcept;
  [[nodiscard]] bool acts_after_its_watchdog() const noexcept;
  [[nodiscard]] bool is_truthful() const noexcept;

  FaultCase fault_;
  std::unique_ptr<DriverBench> bench_;
  std::optional<BenchDevice> device_;
  std::unique_ptr<Servo> servo_;
  std::unique_ptr<Session> session_;
  Document start_;
  ToolPath path_ = ToolPath::kAway;  // path of the case's tool
  ToolKind kind_ = ToolKind::kEdits;
  double scale_ = 1.0;
  Vec shift_;

  std::int64_t period_ns_ = 1'000'000;
  std::int64_t script_ns_ = 0, offset_ns_ = 0;
  std::int64_t turn_ns_ = 0;
  std::int64_t ends_ns_ = 0, lift_ns_ = 0, arm_ns_ = 0;
  Phase phase_ = Phase::kBefore;
  bool is_repeat_ = false;    // the second call of a double tick
  bool is_reported_ = false;  // the session has been notified that the device is gone
  bool was_tried_ = false;    // a reconnect was tried while the device was still unplugged
  Random random_;

  // State of the rules.
  std::int64_t since_ns_ = 0;  // script time of the first tick with the fault
  std::int64_t last_now_ns_ = 0;
  bool has_last_ = false;
  double last_held_n_ = 0.0;
  SafetyState last_state_ = SafetyState::kOff;
  bool must_be_zero_ = false;
  bool was_zero_ = false;
  bool saw_latch_ = false;
  bool was_gone_ = false;
  int free_ticks_ = 0;  // ticks in which the fault may cause a jump of the force
  std::int64_t asked_long_ = 0;
  int calm_ticks_ = 0;     // successive ticks with a request small enough to engage
  bool was_calm_ = false;  // long enough since the user armed again
  std::vector<PenSample> believed_;
  Fnv1a hash_;
  FaultVerdict verdict_;
};

}  // namespace felt
