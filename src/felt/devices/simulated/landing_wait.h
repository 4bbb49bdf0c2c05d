#pragma once

#include <cstdint>

#include "felt/devices/simulated/gliding_aim.h"
#include "felt/devices/simulated/held_body.h"

namespace felt {

/// Decides when a simulated hand puts its stylus down (R18). The stylus has mass, so it follows a
/// fast pointer some centimetres behind. If it landed at once, the ink would begin where it happens
/// to be, with a hook from there to the place of the press. So the hand first moves above that
/// place, waits there until the stylus has come to rest, and puts it down. A stylus that still
/// touches the surface is lifted first, so that each press is a touch of its own. The aims after
/// the landing wait until the stylus touches the surface.
///
/// The waits are bounded: a hand that cannot move the stylus to that place (friction, a wall of the
/// workspace) puts it down nevertheless. Used on the haptic thread; real-time safe. A value type.
class LandingWait {
 public:
  static constexpr double kNearMm = 0.5;
  static constexpr double kSlowMmPerS = 20.0;
  /// The hand puts the stylus down from at most this height. From higher up it would bounce.
  static constexpr double kMaxHeightMm = 6.0;
  /// The hand that slows a rising stylus down aims at least so high: it does not press.
  static constexpr double kMinHeightMm = 0.5;
  /// Maximum wait above the place of the press, after the aim has arrived there. It is shorter the
  /// later the hand already is, so that the waits of many quick strokes do not add up.
  static constexpr std::int64_t kMaxAboveNs = 250'000'000;
  /// A hand that is so late waits only until the stylus is off the surface.
  static constexpr std::int64_t kMaxLateNs = 400'000'000;
  /// Maximum wait from the aim at the surface until the stylus touches it.
  static constexpr std::int64_t kMaxDownNs = 60'000'000;

  /// Returns true if `next`, the aim that is due, must wait; it is late by `late_ns`. Then it may
  /// set `aim` above the place of the press; `tick_ns` is the time until the next read. Call it at
  /// every read while an aim is due, and use the aim once it returns false.
  [[nodiscard]] bool holds(const Aim& next, std::int64_t late_ns, const HeldBody& body,
                           std::int64_t now_ns, std::int64_t tick_ns, GlidingAim& aim) noexcept;

 private:
  enum class Phase : std::uint8_t { kNone, kAbove, kDown };

  [[nodiscard]] bool is_at_rest(const Aim& next, const HeldBody& body) noexcept;

  Phase phase_ = Phase::kNone;
  Vec3 above_mm_;                // where the hand waits
  std::int64_t arrives_ns_ = 0;  // when the aim is above the place of the press
  std::int64_t until_ns_ = 0;    // end of the wait
  bool is_stuck_ = false;        // friction held the stylus at the last read
};

}  // namespace felt
