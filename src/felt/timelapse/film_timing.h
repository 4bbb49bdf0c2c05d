#pragma once

#include <cstdint>
#include <optional>

namespace felt {

/// The wanted length of a film. Values beyond a range are clamped to it.
struct FilmLength {
  static constexpr double kMinSeconds = 0.1, kMaxSeconds = 3600.0;
  static constexpr double kUsualSeconds = 30.0;

  /// Length with the hold at the end, kMinSeconds..kMaxSeconds. If not set: kUsualSeconds, or less
  /// if the drawing took less time (DrawingTime), so that the film is never slower than the hand.
  std::optional<double> seconds{};
  int frames_per_second = 24;  ///< 1..100
  double hold_s = 1.0;         ///< how long the last picture stays; at most half of the film
};

/// Maps the frames of a film to the time of a drawing. The frames before the hold are spread evenly
/// over the drawing; all frames of the hold show its end.
class FilmTiming {
 public:
  /// `drawing_ns` is the length of the drawing in DrawingTime, at least 0.
  FilmTiming(std::int64_t drawing_ns, const FilmLength& length);

  /// Returns the number of frames: the length in seconds times the frames per second, rounded.
  [[nodiscard]] std::int64_t frames() const noexcept { return frames_; }
  /// Returns the DrawingTime that a frame shows: 0 for the first frame, the end of the drawing for
  /// the last one, and never less than for the frame before. Requires 0 <= frame < frames().
  [[nodiscard]] std::int64_t at(std::int64_t frame) const noexcept;
  /// Returns the position in the film, in seconds, of a DrawingTime.
  [[nodiscard]] double film_s(std::int64_t drawing_ns) const noexcept;
  /// Returns the length of the film in seconds.
  [[nodiscard]] double length_s() const noexcept {
    return static_cast<double>(frames_) / frames_per_second_;
  }

 private:
  std::int64_t drawing_ns_;
  double frames_per_second_;
  std::int64_t frames_ = 1;
  std::int64_t moving_ = 0;  // frames before the hold
};

}  // namespace felt
