#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "felt/devices/simulated/moving_aim.h"

namespace felt {

/// An aim and the time at which the hand had it, on the clock of the loop.
struct StampedAim {
  static constexpr std::int64_t kNow = INT64_MIN;  ///< from the next read on

  Aim aim;
  std::int64_t time_ns = kNow;
};

/// Plays the aims of a tablet with their original spacing in time, although a window system
/// delivers them late and several at once. Each aim is played when it is `delay` old. The delay is
/// the one that the aims of the last second or two needed, at most 15 ms; an aim that comes later
/// is played immediately. So the delay does not grow, and no aim is lost.
///
/// With `joins`, at() interpolates linearly between an aim and the next, so the next must be known
/// when the first is played: the delay is longer by the time between them. After a rest the
/// interpolation starts 10 ms before the new aim.
///
/// Value type; real-time safe.
class AimTrack {
 public:
  static constexpr std::size_t kMax = 64;
  static constexpr std::int64_t kMaxDelayNs = 15'000'000;
  static constexpr std::int64_t kLongestWayNs = 10'000'000;
  static constexpr std::int64_t kMinSpacingNs = 50'000;

  explicit AimTrack(bool joins) noexcept : joins_(joins) {}

  /// Appends an aim. Times that do not grow are moved 50 us apart, and future times to now.
  /// Requires has_room().
  void push(const StampedAim& aim, std::int64_t now_ns) noexcept;
  [[nodiscard]] bool has_room() const noexcept { return count_ < kMax; }
  [[nodiscard]] bool is_set() const noexcept { return is_set_; }

  /// Returns the oldest aim that is due by now, or null.
  [[nodiscard]] const Aim* due(std::int64_t now_ns) noexcept;
  /// Returns when the oldest aim is due. Requires one.
  [[nodiscard]] std::int64_t due_ns() const noexcept { return waiting_[head_].time_ns + delay_ns_; }
  /// Removes the oldest aim after it was played; at() then starts from it. Requires one.
  void pass() noexcept;
  /// Returns the aim between the last one passed and the next. Pressure is interpolated if both
  /// press, tilt if both have it; else they are those of the last one. Requires is_set().
  [[nodiscard]] Aim at(std::int64_t now_ns) noexcept;

  /// Returns the current playback delay.
  [[nodiscard]] std::int64_t delay_ns() const noexcept { return delay_ns_; }
  /// Removes all aims and resets the delay.
  void clear() noexcept { *this = AimTrack(joins_); }

 private:
  struct Waiting {
    Aim aim;
    std::int64_t start_ns = 0;  // of the interpolation towards it
    std::int64_t time_ns = 0;
  };

  [[nodiscard]] std::int64_t played_ns(std::int64_t now_ns) noexcept;

  bool joins_;
  bool is_set_ = false;
  std::array<Waiting, kMax> waiting_{};  // ring
  std::size_t head_ = 0, count_ = 0;
  Aim passed_;
  std::int64_t newest_ns_ = 0;  // time of the newest aim
  std::int64_t delay_ns_ = 0;
  std::int64_t played_ns_ = INT64_MIN;  // never goes back, even if the delay grows
};

}  // namespace felt
