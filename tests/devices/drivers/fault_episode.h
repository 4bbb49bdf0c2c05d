#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "felt/base/hash.h"
#include "felt/devices/simulated/random.h"
#include "felt/rt/servo.h"
#include "felt/session/session.h"
#include "tests/devices/drivers/bench_device.h"
#include "tests/devices/drivers/fault_case.h"

namespace felt {

/// What came of a case, all of it measured at the other side, by the fake's motors.
struct FaultVerdict {
  std::string broken{};  ///< empty: all rules were kept
  std::uint64_t ticks = 0;
  double force_before_n = 0.0;  ///< that was held when it happened
  /// Until none was; nothing where the force need not go.
  std::optional<std::int64_t> zero_after_ns{};
  double force_after_n = 0.0;  ///< the largest after forces were engaged again
  bool reconnected = false;
  std::uint64_t digest = 0;  ///< of all poses, forces and the drawing
};

/// A short drawing session with every layer in its place: a hand behind the fake, the driver's real
/// code, loop and safety chain, a session with its tools. Forces engage, the pen comes down, moves;
/// something goes wrong; the hand goes on and lifts; the user mends what must be mended and arms;
/// the pen comes down again.
///
/// The rules, at each tick:
///   - no force is held that the device's row does not allow, none that is no number, and it grows
///     by 0.3 N/ms at most, by 0.01 N/ms while it engages
///   - a fault that takes force away leaves none within its time, and none comes back until the
///     user has armed
///   - what is still read is still told to the session
///   - kDisconnected is for ever
///   - what the tick reports as sent is what the other side was told
/// and at the end: forces are back; every sample that was believed is ink (pencil); undo leads back
/// to the first drawing; no rule of the vendor was broken.
class FaultEpisode {
 public:
  FaultEpisode(const BenchMaker& make, const FaultCase& fault);

  FaultVerdict run();

 private:
  enum class Phase { kBefore, kDuring, kAfter, kAgain };

  // fault_episode.cc: what happens.
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

  // fault_rules.cc: what must be kept.
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
  [[nodiscard]] bool is_hard() const noexcept;
  [[nodiscard]] bool acts_after_its_watchdog() const noexcept;
  [[nodiscard]] bool tells_the_truth() const noexcept;

  FaultCase fault_;
  std::unique_ptr<DriverBench> bench_;
  std::optional<BenchDevice> device_;
  std::unique_ptr<Servo> servo_;
  std::unique_ptr<Session> session_;
  Document start_;
  ToolPath path_ = ToolPath::kAway;  // of the tool of the case
  ToolKind kind_ = ToolKind::kEdits;
  double scale_ = 1.0;
  Vec shift_;

  std::int64_t period_ns_ = 1'000'000;
  std::int64_t script_ns_ = 0, offset_ns_ = 0;
  std::int64_t turn_ns_ = 0;
  std::int64_t ends_ns_ = 0, lift_ns_ = 0, arm_ns_ = 0;
  Phase phase_ = Phase::kBefore;
  bool is_repeat_ = false;  // of a double tick
  bool is_told_ = false;    // the session, that the device is gone
  bool was_tried_ = false;  // to reconnect while it was still unplugged
  Random random_;

  // What the rules remember.
  std::int64_t since_ns_ = 0;  // script time of the first tick with the fault
  std::int64_t last_now_ns_ = 0;
  bool has_last_ = false;
  double last_held_n_ = 0.0;
  SafetyState last_state_ = SafetyState::kOff;
  bool must_be_zero_ = false;
  bool was_zero_ = false;
  bool saw_latch_ = false;
  bool was_gone_ = false;
  int free_ticks_ = 0;  // in which a jump of the force is the fault's
  std::int64_t asked_long_ = 0;
  int calm_ticks_ = 0;     // in a row, in which little enough was asked for to engage
  bool was_calm_ = false;  // for long enough, since the user armed again
  std::vector<PenSample> believed_;
  Fnv1a hash_;
  FaultVerdict verdict_;
};

}  // namespace felt
