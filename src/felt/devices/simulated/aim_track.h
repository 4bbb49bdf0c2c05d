#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "felt/devices/simulated/moving_aim.h"

namespace felt {

/// An aim, and when the hand wanted it; on the clock of the loop.
struct StampedAim {
  static constexpr std::int64_t kNow = INT64_MIN;  ///< from the next read on

  Aim aim;
  std::int64_t time_ns = kNow;
};

/// Plays the aims of a tablet in their own spacing in time, however they arrive: a window system
/// hands them over late and several at once. Each is played when it is `delay` old. The delay is
/// what the aims of the last second or two have needed, 15 ms at most; an aim that comes later than
/// that is played at once. So it neither grows nor loses any.
///
/// With `joins`, at() moves evenly from an aim to the next, which must then be known when the one
/// before is played: the delay is longer by the time between two. After a rest the way starts 10 ms
/// before the aim.
///
/// A value; real-time safe.
class AimTrack {
 public:
  static constexpr std::size_t kMost = 64;
  static constexpr std::int64_t kMostDelayNs = 15'000'000;
  static constexpr std::int64_t kLongestWayNs = 10'000'000;
  static constexpr std::int64_t kLeastSpacingNs = 50'000;

  explicit AimTrack(bool joins) noexcept : joins_(joins) {}

  /// The next aim arrives. Times that do not grow are spread by 50 us; none is in the future.
  /// Requires room.
  void push(const StampedAim& aim, std::int64_t now_ns) noexcept;
  [[nodiscard]] bool has_room() const noexcept { return count_ < kMost; }
  [[nodiscard]] bool is_set() const noexcept { return is_set_; }

  /// The oldest aim whose turn has come by now; null where there is none.
  [[nodiscard]] const Aim* due(std::int64_t now_ns) noexcept;
  /// When the oldest aim is played. Requires one.
  [[nodiscard]] std::int64_t due_ns() const noexcept { return waiting_[head_].time_ns + delay_ns_; }
  /// It has been played: the way to the next begins there. Requires one.
  void pass() noexcept;
  /// Between the last aim that was passed and the next. Pressure moves where both press, lean where
  /// both know it; else they are the last one's. Requires is_set().
  [[nodiscard]] Aim at(std::int64_t now_ns) noexcept;

  /// What is played now is so old.
  [[nodiscard]] std::int64_t delay_ns() const noexcept { return delay_ns_; }
  /// Forgets all of it.
  void clear() noexcept { *this = AimTrack(joins_); }

 private:
  struct Waiting {
    Aim aim;
    std::int64_t start_ns = 0;  // of the way there
    std::int64_t time_ns = 0;
  };

  [[nodiscard]] std::int64_t played_ns(std::int64_t now_ns) noexcept;

  bool joins_;
  bool is_set_ = false;
  std::array<Waiting, kMost> waiting_{};  // ring
  std::size_t head_ = 0, count_ = 0;
  Aim passed_;
  std::int64_t newest_ns_ = 0;  // time of the aim that came last
  std::int64_t delay_ns_ = 0;
  std::int64_t played_ns_ = INT64_MIN;  // never goes back, whatever the delay does
};

}  // namespace felt
