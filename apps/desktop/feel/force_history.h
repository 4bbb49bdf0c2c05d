#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "felt/rt/servo.h"

namespace felt::desktop {

/// The last seconds of a loop's forces, for a plot: strengths in N of each term by name, of what is
/// asked and of what is sent. A ring of short bins that keep the largest value of their ticks, so
/// that no peak is missed whatever the plot's resolution. Adding costs well under a microsecond and
/// allocates nothing. One thread.
class ForceHistory {
 public:
  static constexpr std::int64_t kBinNs = 10'000'000;
  static constexpr std::size_t kBins = 400;   ///< 4 s
  static constexpr std::size_t kAsked = 0;    ///< track: asked of the device
  static constexpr std::size_t kSent = 1;     ///< track: sent to it
  static constexpr std::size_t kTracks = 12;  ///< those two and ten terms; more are left out

  ForceHistory() noexcept { clear(); }

  /// Terms are shown as the hand would feel them: times the master strength. A tick that is older
  /// than the last one starts anew.
  void add(const TickReport& tick) noexcept;
  void clear() noexcept;

  [[nodiscard]] bool is_empty() const noexcept { return newest_ < 0; }
  /// Tracks that have appeared so far.
  [[nodiscard]] std::size_t tracks() const noexcept { return tracks_; }
  /// "asked", "sent", or the name of the brick.
  [[nodiscard]] const char* name(std::size_t track) const noexcept { return names_[track]; }
  /// Number of the newest bin, counted from time 0; negative while there is none. It may still
  /// grow.
  [[nodiscard]] std::int64_t newest() const noexcept { return newest_; }
  /// Largest value in N of the bin of that number. Negative: no tick fell into it, or it is gone.
  [[nodiscard]] float at(std::size_t track, std::int64_t bin) const noexcept;
  /// Of the last tick, N.
  [[nodiscard]] float now(std::size_t track) const noexcept { return now_[track]; }
  /// Of all that is kept, N; 0 without any.
  [[nodiscard]] float most(std::size_t track) const noexcept;

 private:
  static constexpr float kNothing = -1.0F;

  void go_to(std::int64_t bin) noexcept;
  [[nodiscard]] std::size_t track_of(const char* name) noexcept;
  void put(std::size_t track, double newton) noexcept;

  std::array<std::array<float, kBins>, kTracks> bins_{};
  std::array<const char*, kTracks> names_{};
  std::array<float, kTracks> now_{};
  std::size_t tracks_ = 2;
  std::int64_t newest_ = -1;  // number of the bin, from time 0 on
};

}  // namespace felt::desktop
