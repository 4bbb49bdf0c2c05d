#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "felt/devices/simulated/gliding_aim.h"

namespace felt {

/// An aim (the position that the simulated hand wants) and the time at which the hand had this aim,
/// on the clock of the loop.
struct StampedAim {
  static constexpr std::int64_t kNow = INT64_MIN;  ///< takes effect at the next read

  Aim aim;
  std::int64_t time_ns = kNow;
};

/// Plays the aims of a tablet with their original spacing in time, although a window system
/// delivers them late and several at once. Each aim is played when its age reaches the playback
/// delay. The delay is about the largest age that an aim had on arrival in the last second or two,
/// but at most 15 ms. An aim that is older than the delay on arrival is played immediately. So the
/// delay does not keep growing, and no aim is lost.
///
/// With `Play::kPaced`, for a stylus with a body, aims that are late are not played together: their
/// spacing shrinks, the more the later they are, and the body moves along all of them. They are
/// late after a stall of the program or after hold().
///
/// With `Play::kJoined`, at() interpolates linearly between one aim and the next. This requires
/// that the second aim is known when the first is played, so the delay is longer by the time
/// between the two aims. After a rest, the interpolation starts at most 10 ms before the time of
/// the new aim.
///
/// A value type, real-time safe.
class AimTrack {
 public:
  static constexpr std::size_t kMax = 64;
  static constexpr std::int64_t kMaxDelayNs = 15'000'000;
  static constexpr std::int64_t kLongestWayNs = 10'000'000;
  static constexpr std::int64_t kMinSpacingNs = 50'000;
  /// An aim that is so late is played at twice the speed of the hand.
  static constexpr std::int64_t kCatchUpNs = 500'000'000;

  enum class Play : std::uint8_t { kPaced, kJoined };

  explicit AimTrack(Play play) noexcept : play_(play) {}

  /// Appends an aim. If the aim's time is in the future, it is set to `now_ns`. If it is less than
  /// 50 us after the time of the last aim, it is set to 50 us after that time. Requires has_room().
  void push(const StampedAim& aim, std::int64_t now_ns) noexcept;
  [[nodiscard]] bool has_room() const noexcept { return count_ < kMax; }
  [[nodiscard]] bool is_set() const noexcept { return is_set_; }

  /// Returns the oldest aim that is due by now, or null.
  [[nodiscard]] const Aim* due(std::int64_t now_ns) noexcept;
  /// Returns the time at which the oldest aim is due. Requires that an aim waits.
  [[nodiscard]] std::int64_t due_ns() const noexcept;
  /// Returns how late the oldest aim is now, at least 0. Requires that an aim waits.
  [[nodiscard]] std::int64_t late_ns(std::int64_t now_ns) const noexcept {
    return std::max<std::int64_t>(0, now_ns - waiting_[head_].time_ns - delay_ns_);
  }
  /// Removes the oldest aim after it was played; from then on, at() interpolates from this aim.
  /// Requires that an aim waits.
  void pass() noexcept;
  /// Postpones the oldest aim, which is due, and all later ones, to `now_ns` or later. Requires
  /// that an aim waits.
  void hold(std::int64_t now_ns) noexcept { held_ns_ = now_ns; }
  /// Returns the aim at this time, interpolated between the last aim that pass() removed and the
  /// next. Pressure is interpolated if both aims press, and tilt if both aims have a tilt;
  /// otherwise the values of the removed aim are used. Requires is_set().
  [[nodiscard]] Aim at(std::int64_t now_ns) noexcept;

  /// Returns the current playback delay.
  [[nodiscard]] std::int64_t delay_ns() const noexcept { return delay_ns_; }
  /// Removes all aims and resets the delay.
  void clear() noexcept { *this = AimTrack(play_); }

 private:
  struct Waiting {
    Aim aim;
    std::int64_t start_ns = 0;  // start of the interpolation towards this aim
    std::int64_t time_ns = 0;
  };

  [[nodiscard]] std::int64_t played_ns(std::int64_t now_ns) noexcept;

  Play play_;
  bool is_set_ = false;
  std::array<Waiting, kMax> waiting_{};  // ring
  std::size_t head_ = 0, count_ = 0;
  Aim passed_;
  std::int64_t passed_time_ns_ = INT64_MIN;  // time of the last aim that was removed
  std::int64_t passed_due_ns_ = INT64_MIN;   // when it was due
  std::int64_t held_ns_ = INT64_MIN;         // hold() was called then
  std::int64_t newest_ns_ = 0;               // time of the newest aim
  std::int64_t delay_ns_ = 0;
  std::int64_t played_ns_ = INT64_MIN;  // playback time; never decreases, even if the delay grows
};

}  // namespace felt
