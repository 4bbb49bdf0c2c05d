#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "felt/rt/servo.h"

namespace felt::desktop {

/// The forces of a haptic loop in the last seconds, for a plot. It has one track for the requested
/// force, one for the sent force, and one for each named force term; a track stores the magnitude
/// of its force in N. A ring buffer of short bins keeps the maximum of the ticks in each bin, so
/// that a plot of any resolution shows every peak. Adding a tick takes well under a microsecond and
/// allocates nothing. Not thread-safe.
class ForceHistory {
 public:
  static constexpr std::int64_t kBinNs = 10'000'000;
  static constexpr std::size_t kBins = 400;   ///< 4 s
  static constexpr std::size_t kAsked = 0;    ///< track of the force that the tool requests
  static constexpr std::size_t kSent = 1;     ///< track of the force sent to the device
  static constexpr std::size_t kTracks = 12;  ///< kAsked, kSent and ten terms; further terms are
                                              ///< ignored

  ForceHistory() noexcept { clear(); }

  /// Adds a tick. The terms are multiplied by the master strength, so that they are the forces that
  /// the hand feels. If the tick is older than the previous one, clears the history first.
  void add(const TickReport& tick) noexcept;
  void clear() noexcept;

  [[nodiscard]] bool is_empty() const noexcept { return newest_ < 0; }
  /// Returns the number of tracks that have appeared so far.
  [[nodiscard]] std::size_t tracks() const noexcept { return tracks_; }
  /// Returns "asked", "sent", or the name of the force term.
  [[nodiscard]] const char* name(std::size_t track) const noexcept { return names_[track]; }
  /// Returns the number of the newest bin, counted from time 0; negative if the history is empty.
  /// Later ticks may still increase its values.
  [[nodiscard]] std::int64_t newest() const noexcept { return newest_; }
  /// Returns the largest value in a bin, in N. Returns a negative number if no tick fell into the
  /// bin, or if the bin is no longer stored.
  [[nodiscard]] float at(std::size_t track, std::int64_t bin) const noexcept;
  /// Returns the value of the last tick, in N.
  [[nodiscard]] float now(std::size_t track) const noexcept { return now_[track]; }
  /// Returns the largest stored value, in N; 0 if the history is empty.
  [[nodiscard]] float largest(std::size_t track) const noexcept;

 private:
  static constexpr float kNothing = -1.0F;

  void go_to(std::int64_t bin) noexcept;
  [[nodiscard]] std::size_t track_of(const char* name) noexcept;
  void put(std::size_t track, double newton) noexcept;

  std::array<std::array<float, kBins>, kTracks> bins_{};
  std::array<const char*, kTracks> names_{};
  std::array<float, kTracks> now_{};
  std::size_t tracks_ = 2;
  std::int64_t newest_ = -1;  // number of the bin, counted from time 0
};

}  // namespace felt::desktop
