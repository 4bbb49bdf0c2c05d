#pragma once

#include <cstdint>

#include "felt/geometry/vec3.h"
#include "felt/haptics/force.h"
#include "felt/haptics/pen_sample.h"
#include "felt/haptics/safety/safety_limits.h"

/// The monitors of the safety chain. Each guard has its own state from tick to tick.
namespace felt {

/// How late a tick came.
enum class Lateness : std::uint8_t {
  kOnTime,
  kLate,      ///< more than late_s after the previous tick
  kVeryLate,  ///< more than very_late_s; the motion of the pen in between is unknown
};

/// The time since the last tick, in three versions. If the time is uncertain, the chain must use
/// the smaller force. So stages that let a force grow use the short `credited_s`, and stages that
/// reduce a force use the long `charged_s`.
struct TickTime {
  double model_s = 0.001;  ///< for the force models: clamped to 0.2..5 ms
  double credited_s =
      0.0;  ///< for rises and ramps: at most two periods, at most 5 ms; 0 if the clock stops
  double charged_s = 0.001;  ///< for watchdogs, falls, heat: at least 0.2 ms, no upper bound
  Lateness lateness = Lateness::kOnTime;
};

/// Measures ticks (docs/design/limits.md#tick-time). If time stands still or runs backwards,
/// credited_s is 0. A clock that runs backwards by t counts as late by t. Real-time safe.
class TickClock {
 public:
  explicit TickClock(const SafetyLimits& limits) noexcept;

  /// Returns the time since the last tick. The first tick counts as one period. Accepts any times,
  /// even if their difference overflows.
  TickTime tick(std::int64_t now_ns) noexcept;

 private:
  double period_s_;
  double late_s_;
  double very_late_s_;
  std::int64_t last_ns_ = 0;
  bool has_last_ = false;
};

/// Monitors the heartbeats of the edit thread (docs/design/limits.md#edit-side). Silence is
/// measured on the chain's own clock, so that a clock that stops or jumps cannot hide it. If the
/// same heartbeat is added twice, it counts once.
class HeartbeatWatch {
 public:
  /// Adds a heartbeat, with the time at which it was made.
  void beat(std::int64_t made_ns) noexcept;
  /// Sets the silence to 0, for example when the user arms the chain.
  void restart() noexcept;
  /// Counts a tick and returns the silence in s.
  double tick(std::int64_t now_ns, const TickTime& time) noexcept;

 private:
  double silence_s_ = 0.0;
  std::int64_t last_beat_ns_ = 0;
  bool has_beat_ = false;
  bool is_new_ = false;
};

/// Returns true if every number of the sample is finite.
bool is_finite(const PenSample& sample) noexcept;

/// Returns true if a sample is not newer than `last`: it has the same time, position and velocity.
/// This does not mean that the pen stands still.
bool repeats(const PenSample& last, const PenSample& sample) noexcept;

/// The result of checking a position.
enum class PositionVerdict : std::uint8_t {
  kBelieved,
  kHeld,   ///< too far from the last accepted position: not used; the last force continues
  kFault,  ///< too far for too long
};

/// Detects positions that jump by more than 3 mm/ms. A position that is too far from the last
/// accepted one is held, that is, it is not used. The permitted distance is that of one tick. It
/// does not grow while positions are held, so a jump does not become plausible by waiting. Ticks
/// without a new sample (wait()) count as part of the next tick, because the pen continues to move
/// while the answers of a device are late. The permitted distance is at most that of kMaxReachS,
/// even after a very late tick. A single jump is forgiven if positions return within jump_hold_s.
/// Repeated jumps are not: the time of held positions adds up, the time of accepted positions
/// reduces the sum by only an eighth of itself, and a sum of kMaxDoubtS is a fault. So a position
/// that is wrong in every second sample is a fault after about 20 ms, and one that is wrong in
/// every ninth never is.
class JumpGuard {
 public:
  static constexpr double kMaxDoubtS = 0.010;
  static constexpr double kMaxReachS = 0.025;

  explicit JumpGuard(const SafetyLimits& limits) noexcept;

  /// Forgets the last position, so that the next one is accepted. Also clears all doubt.
  void reset() noexcept {
    has_last_ = is_holding_ = false;
    doubt_s_ = waited_s_ = 0.0;
  }
  /// Counts a tick without a new sample.
  void wait(const TickTime& time) noexcept { waited_s_ += time.model_s; }
  /// Returns true if a position has been accepted and the last position was not held.
  [[nodiscard]] bool may_wait() const noexcept { return has_last_ && !is_holding_; }
  PositionVerdict judge(const Vec3& position_mm, const TickTime& time) noexcept;

 private:
  double jump_mm_per_s_;
  double hold_s_;
  Vec3 last_mm_;
  bool has_last_ = false;
  bool is_holding_ = false;
  double held_s_ = 0.0;
  double waited_s_ = 0.0;  // since the last checked position
  double doubt_s_ = 0.0;   // time of held positions, less an eighth of the accepted time
};

/// Monitors the speed of the pen: the velocity that the device reports or the speed computed from
/// its positions, whichever is higher, so that a device that does not report a velocity is
/// monitored, too. Positions are compared over at least 0.9 of a period, so that ticks that come in
/// bursts do not turn one sensor step into a high speed.
class SpeedGuard {
 public:
  explicit SpeedGuard(const SafetyLimits& limits) noexcept;

  /// Forgets the last position and all speeds.
  void reset() noexcept;
  /// Counts a tick without a new sample. After kMaxSampleGapS the speed is unknown, and counts as
  /// 0, so that a device that freezes is not braked for ever.
  void wait(const TickTime& time) noexcept;
  /// Processes an accepted sample; its numbers are finite and may have any size.
  void update(const PenSample& sample, const TickTime& time) noexcept;

  /// Returns the speed at the last sample, m/s.
  [[nodiscard]] double speed_m_per_s() const noexcept { return speed_m_per_s_; }
  /// Returns the velocity to brake against, mm/s: the one that has that speed, but the measured one
  /// if the reported one does not point the same way, because a brake against it would push.
  [[nodiscard]] const Vec3& velocity_mm_per_s() const noexcept { return velocity_mm_per_s_; }
  /// Returns the velocity from positions alone, low-passed, mm/s.
  [[nodiscard]] const Vec3& measured_mm_per_s() const noexcept { return filter_.velocity(); }
  /// Returns true if forces must be cut: cut_samples samples in a row were above cut_m_per_s, or
  /// one sample was above cut_now_m_per_s.
  [[nodiscard]] bool must_cut() const noexcept { return must_cut_; }

 private:
  void forget_speed() noexcept;

  double cut_m_per_s_;
  double cut_now_m_per_s_;
  int cut_samples_;
  double span_s_;  // positions are compared over at least this time
  double waited_s_ = 0.0;

  bool has_anchor_ = false;
  Vec3 anchor_mm_;
  double since_anchor_s_ = 0.0;
  Vec3 measured_mm_per_s_;
  VelocityFilter filter_;
  int fast_samples_ = 0;
  double speed_m_per_s_ = 0.0;
  Vec3 velocity_mm_per_s_;
  bool must_cut_ = false;
};

/// Returns the force that the motors may hold indefinitely, N. If a force lasts, MotorGuard reduces
/// it to this value. Infinite if the device has no rating.
double sustained_force_n(const SafetyLimits& limits) noexcept;

/// Protects the motors from overheating (docs/design/limits.md#motors: RMS over 10 s at most 80 %
/// of the rating, then a fade over 1 s with a notice).
///
/// The mean square m of the force is low-pass filtered with a time constant tau of half the window,
/// which models how a motor warms. The bound of m keeps the plain RMS over any whole window below
/// the limit L: the energy of a window W is at most tau m + W m, so m <= L^2 W/(W + tau). The
/// permitted force depends only on m: the farther m is below its bound, the higher this force is.
/// When m reaches the bound, the permitted force is the sustainable force sqrt(m); the fade from
/// the peak takes about fade_s. So a hand that keeps pressing feels the plane become softer once.
/// The force is never cut off and does not oscillate.
class MotorGuard {
 public:
  explicit MotorGuard(const SafetyLimits& limits) noexcept;

  /// Adds the heat of a force_n that is held for duration_s.
  void heat(double force_n, double duration_s) noexcept;
  /// Returns the permitted force, N; infinite if the device has no rating.
  [[nodiscard]] double allowed_n() const noexcept;
  /// Returns the root of the mean square, N.
  [[nodiscard]] double rms_n() const noexcept;
  /// Returns true if the notice should be shown: from a tick with `limited` (the force was limited
  /// on that tick) until the mean square has fallen below half of its bound. This hysteresis
  /// applies to the notice only, not to the force.
  bool is_warm(bool limited) noexcept;

 private:
  double tau_s_;
  double sustained_n_;  // 0 = no bound
  double gain_;         // of the fade, N^2 per N^2
  double mean_square_ = 0.0;
  bool warm_ = false;
};

/// Passivity observer (docs/design/limits.md#passivity, after Hannaford and Ryu): computes the work
/// that the sent forces have done on the hand since the pen last touched. The force of a tick is
/// held until the next one, so its work is that force times the pen's displacement in between. It
/// uses positions and not velocities, so noise does not add up.
class PassivityObserver {
 public:
  /// Forgets all state, so that the next sample counts as the first.
  void reset() noexcept;
  /// Adds a sample. The device has held `sent` since the previous one. Returns the energy in mJ.
  /// The energy is positive if the loop has given the hand more than it received. Huge numbers
  /// saturate.
  double update(const PenSample& sample, const Force& sent) noexcept;

 private:
  bool has_last_ = false;
  bool was_in_contact_ = false;
  Vec3 last_mm_;
  double energy_mj_ = 0.0;
};

}  // namespace felt
