#pragma once

#include <cstdint>

#include "felt/geometry/vec3.h"
#include "felt/haptics/pen_sample.h"
#include "felt/haptics/safety/safety_clock.h"
#include "felt/haptics/safety/safety_limits.h"

namespace felt {

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

}  // namespace felt
