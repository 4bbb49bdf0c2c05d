#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "felt/devices/hapticmaster/controller_text.h"
#include "felt/geometry/vec3.h"

namespace felt::hapticmaster {

/// The position and velocity of the machine that the controller reports in one tick.
struct MotionReport {
  std::optional<Vec3> position_mm;        ///< nullopt if it was not three finite numbers
  std::optional<Vec3> velocity_mm_per_s;  ///< the same
  std::int64_t asked_ns = 0;              ///< when they were asked for: a sum of LoopTime
};

enum class MotionVerdict : std::uint8_t {
  kGood,
  kImpossible,    ///< not a number, outside the reach, too fast, or a jump: must not be used
  kInconsistent,  ///< positions and velocities contradict each other: must not last
};

/// Checks the positions that the controller reports.
///
/// A position is impossible if it is outside the reach of the machine, or if it is farther from the
/// last one than a hand can move.
///
/// Positions and velocities are inconsistent in two cases. First, the difference between the
/// movement of the position and the integral of the velocity over about kMemoryS is larger than the
/// controller's delays explain: kErrorMm, and the way of kLagS at the highest recent speed. Second,
/// a coordinate stays within kStillMm although its velocity is above kMovingMmPerS, until the part
/// above that adds up to kFrozenMm. This finds a coordinate that is frozen while a hand moves to
/// and fro. A hand that rests shows neither: its velocity is below kMovingMmPerS, or its position
/// changes.
///
/// It cannot be noticed that position and velocity are frozen together while the hand had been at
/// rest. Used on the haptic thread; real-time safe.
class MotionCheck {
 public:
  static constexpr double kBeyondMm = 50.0;       ///< a position farther outside is impossible
  static constexpr double kMaxSpeedMmPerS = 1e5;  ///< the safety chain cuts the force far below
  /// The chain would not call it a jump, because a pen may move 12 mm in the 4 ms of a tick.
  static constexpr double kMaxErrorMmPerS = 1500.0;
  /// The first positions in a row: a jump in them cannot be told from a first movement.
  static constexpr int kSteadyPositions = 5;
  static constexpr std::int64_t kMaxStepNs = 50'000'000;  ///< later positions begin anew

  static constexpr double kErrorMm = 5.0;
  static constexpr double kLagS = 0.02;
  static constexpr double kMemoryS = 1.0;
  static constexpr double kSpeedMemoryS = 0.25;
  static constexpr double kStillMm = 0.05;  ///< four position steps of the machine
  static constexpr double kMovingMmPerS = 10.0;
  static constexpr double kFrozenMm = 2.0;
  /// The velocity within a longer step is not known well enough to add it up.
  static constexpr std::int64_t kMaxSumNs = 12'000'000;

  /// `reach` contains every position of the machine.
  explicit MotionCheck(const Box& reach) noexcept : reach_(reach) {}

  /// Forgets everything, because the machine was prepared again or the loop stood still.
  void restart() noexcept { *this = MotionCheck(reach_); }
  MotionVerdict judge(const MotionReport& report) noexcept;

 private:
  struct Frozen {
    double at_mm = 0.0;
    double way_mm = 0.0;  // integral of the speed above kMovingMmPerS since the position was left
  };
  [[nodiscard]] bool is_possible(const MotionReport& report) const noexcept;
  void add(const Vec3& step_mm, const Vec3& mean_mm_per_s, double step_s) noexcept;
  void follow_still(const Vec3& position_mm, const Vec3& mm_per_s, double step_s) noexcept;
  [[nodiscard]] bool is_consistent() const noexcept;

  Box reach_;
  int positions_ = 0;  // in a row, counted up to kSteadyPositions
  Vec3 last_mm_, last_mm_per_s_;
  std::int64_t last_ns_ = 0;
  Vec3 error_mm_;
  double speed_mm_per_s_ = 0.0;  // the highest of the last time
  std::array<Frozen, 3> frozen_{};
};

}  // namespace felt::hapticmaster
