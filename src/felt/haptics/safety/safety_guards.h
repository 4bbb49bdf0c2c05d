#pragma once

#include <cstdint>

#include "felt/geometry/vec3.h"
#include "felt/haptics/force.h"
#include "felt/haptics/pen_sample.h"
#include "felt/haptics/safety/safety_limits.h"

/// What the safety chain watches, each guard with the state that it needs from tick to tick.
namespace felt {

/// How late a tick came.
enum class Lateness : std::uint8_t {
  kOnTime,
  kLate,      ///< over late_s since the last one
  kVeryLate,  ///< over very_late_s; what the pen did meanwhile is not known
};

/// The time since the last tick, three ways. A doubt about time is settled against the force: what
/// lets a force grow is credited with little time, what takes it away is charged with much.
struct TickTime {
  double model_s = 0.001;    ///< for the models: clamped to 0.2..5 ms
  double credited_s = 0.0;   ///< rise, ramps: at most two periods or 5 ms, 0 when time stands still
  double charged_s = 0.001;  ///< watchdogs, falls, heat: at least 0.2 ms, without an upper bound
  Lateness lateness = Lateness::kOnTime;
};

/// Measures ticks (reliability 3.3). Time that stands still or runs backwards credits nothing;
/// running backwards is as late as it goes back. Real-time safe.
class TickClock {
 public:
  explicit TickClock(const SafetyLimits& limits) noexcept;

  /// The first tick counts as one period. Any two times, even the farthest apart.
  TickTime tick(std::int64_t now_ns) noexcept;

 private:
  double period_s_;
  double late_s_;
  double very_late_s_;
  std::int64_t last_ns_ = 0;
  bool has_last_ = false;
};

/// The edit side's signs of life (architecture section 10: edit side silent). Silence is counted in
/// ticks of the chain's own clock, so that a clock that stops or jumps cannot hide it; the same
/// heartbeat seen twice is one.
class HeartbeatWatch {
 public:
  /// A heartbeat with the time it was made at.
  void beat(std::int64_t made_ns) noexcept;
  /// Starts a new count, as when the user arms.
  void restart() noexcept;
  /// Counts a tick; returns the silence in s.
  double tick(std::int64_t now_ns, const TickTime& time) noexcept;

 private:
  double silence_s_ = 0.0;
  std::int64_t last_beat_ns_ = 0;
  bool has_beat_ = false;
  bool is_new_ = false;
};

/// True when every number of the sample is finite.
bool is_finite(const PenSample& sample) noexcept;

/// True if a device has nothing newer to say than `last`: the same time, position and velocity.
/// Such a sample does not say that the pen stands still.
bool repeats(const PenSample& last, const PenSample& sample) noexcept;

/// What to make of a position.
enum class PositionVerdict : std::uint8_t {
  kBelieved,
  kHeld,   ///< too far from the last believed one: hold the last force
  kFault,  ///< and that for too long
};

/// Detects positions that jump by more than 3 mm/ms. A position is believed if it lies within reach
/// of the last believed one; the reach is that of one tick, so a lasting jump does not become
/// plausible by waiting. Ticks without a new sample (wait()) count as part of the next one, because
/// the pen moves on while a device's answers are late; the reach is that of kMaxReachS at most,
/// also after a tick that was very late. One jump that comes back within jump_hold_s is forgiven.
/// Jumps that come back again and again are not: held time adds up to kMaxDoubtS, and believed time
/// takes only an eighth of itself off, so that a position that lies in every second sample is a
/// fault after about 20 ms, and in one of nine never.
class JumpGuard {
 public:
  static constexpr double kMaxDoubtS = 0.010;
  static constexpr double kMaxReachS = 0.025;

  explicit JumpGuard(const SafetyLimits& limits) noexcept;

  /// Forgets the last position, so that the next one is believed, and all doubts.
  void reset() noexcept {
    has_last_ = is_holding_ = false;
    doubt_s_ = waited_s_ = 0.0;
  }
  /// A tick without a new sample.
  void wait(const TickTime& time) noexcept { waited_s_ += time.model_s; }
  /// True if there is a believed position, and the last one was not held.
  [[nodiscard]] bool may_wait() const noexcept { return has_last_ && !is_holding_; }
  PositionVerdict judge(const Vec3& position_mm, const TickTime& time) noexcept;

 private:
  double jump_mm_per_s_;
  double hold_s_;
  Vec3 last_mm_;
  bool has_last_ = false;
  bool is_holding_ = false;
  double held_s_ = 0.0;
  double waited_s_ = 0.0;  // since the last judged position
  double doubt_s_ = 0.0;   // of held positions, less an eighth of the believed time
};

/// Speed of the pen, by its own account or by its positions, whichever is more: a device that
/// reports no velocity cannot pass. Positions are compared over at least 0.9 of a period, so that
/// ticks that come in bursts do not turn a quantum into a speed.
class SpeedGuard {
 public:
  explicit SpeedGuard(const SafetyLimits& limits) noexcept;

  /// Forgets the last position and all speeds.
  void reset() noexcept;
  /// A tick without a new sample.
  void wait(const TickTime& time) noexcept { since_anchor_s_ += time.charged_s; }
  /// Takes a believed sample; finite numbers of any size.
  void update(const PenSample& sample, const TickTime& time) noexcept;

  /// m/s, at the last sample.
  [[nodiscard]] double speed_m_per_s() const noexcept { return speed_m_per_s_; }
  /// mm/s, of that speed.
  [[nodiscard]] const Vec3& velocity_mm_per_s() const noexcept { return velocity_mm_per_s_; }
  /// True where forces must be cut: cut_samples in a row above cut, or one above cut_now.
  [[nodiscard]] bool must_cut() const noexcept { return must_cut_; }

 private:
  double cut_m_per_s_;
  double cut_now_m_per_s_;
  int cut_samples_;
  double span_s_;  // over which positions are compared

  bool has_anchor_ = false;
  Vec3 anchor_mm_;
  double since_anchor_s_ = 0.0;
  Vec3 measured_mm_per_s_;
  int fast_samples_ = 0;
  double speed_m_per_s_ = 0.0;
  Vec3 velocity_mm_per_s_;
  bool must_cut_ = false;
};

/// The force that the motors may hold for as long as one likes, N: all that MotorGuard lets through
/// in the end. Infinite without a rating.
double sustained_force_n(const SafetyLimits& limits) noexcept;

/// Keeps the motors cool (architecture section 10: RMS over 10 s at most 80 % of the rating, then a
/// fade over 1 s with a notice).
///
/// The mean square m of the force is a low-pass with half the window as time constant, as a motor
/// warms. Its bound is set so that the plain RMS over any whole window stays under the limit L: the
/// energy of a window W is at most tau m + W m, so m <= L^2 W/(W + tau). The force that may be sent
/// depends on m alone: the more room is left, the more; it reaches the sustainable force sqrt(m) as
/// the room is used up, along a fade that takes about fade_s from the peak. So a hand that keeps on
/// pressing feels the plane become softer, once, and never a cut or a swing.
class MotorGuard {
 public:
  explicit MotorGuard(const SafetyLimits& limits) noexcept;

  /// The device held force_n for duration_s.
  void heat(double force_n, double duration_s) noexcept;
  /// The force that may be sent now, N; infinite without a rating.
  [[nodiscard]] double allowed_n() const noexcept;
  /// Root of the mean square, N.
  [[nodiscard]] double rms_n() const noexcept;
  /// Call with whether the limit was met on this tick; true from then until the motors have cooled
  /// to half the heat (hysteresis of the notice, not of the force).
  bool is_warm(bool limited) noexcept;

 private:
  double tau_s_;
  double sustained_n_;  // 0 = no bound
  double gain_;         // of the fade, N^2 per N^2
  double mean_square_ = 0.0;
  bool warm_ = false;
};

/// Passivity observer (reliability 3.2, after Hannaford and Ryu): the work that the sent forces did
/// on the hand since the pen last came down. The force of a tick acts until the next one, so its
/// work is that force times the way of the pen in between; positions, not velocities, and therefore
/// no noise adds up.
class PassivityObserver {
 public:
  /// Forgets everything: the next sample is the first.
  void reset() noexcept;
  /// `sent` was held by the device since the last sample; returns the energy in mJ, > 0 where the
  /// loop gave more than it took. Huge numbers saturate.
  double update(const PenSample& sample, const Force& sent) noexcept;

 private:
  bool has_last_ = false;
  bool was_in_contact_ = false;
  Vec3 last_mm_;
  double energy_mj_ = 0.0;
};

}  // namespace felt
