#include "felt/timelapse/film_timing.h"

#include <algorithm>
#include <cmath>

namespace felt {

FilmTiming::FilmTiming(std::int64_t drawing_ns, const FilmLength& length)
    : drawing_ns_(std::max<std::int64_t>(drawing_ns, 0)),
      frames_per_second_(std::clamp(length.frames_per_second, 1, 100)) {
  const double hold_s = std::max(length.hold_s, 0.0);
  const double usual_s =
      std::min(FilmLength::kUsualSeconds, 1e-9 * static_cast<double>(drawing_ns_) + hold_s);
  const double seconds = std::clamp(length.seconds.value_or(usual_s), FilmLength::kMinSeconds,
                                    FilmLength::kMaxSeconds);
  frames_ = std::max<std::int64_t>(1, std::llround(seconds * frames_per_second_));
  const std::int64_t most_held =
      drawing_ns_ == 0 ? frames_ : std::max<std::int64_t>(1, frames_ / 2);
  const std::int64_t held =
      std::clamp<std::int64_t>(std::llround(hold_s * frames_per_second_), 1, most_held);
  moving_ = frames_ - held;
}

std::int64_t FilmTiming::at(std::int64_t frame) const noexcept {
  if (frame >= moving_) return drawing_ns_;
  // drawing_ns * frame could overflow.
  return drawing_ns_ / moving_ * frame + drawing_ns_ % moving_ * frame / moving_;
}

double FilmTiming::film_s(std::int64_t drawing_ns) const noexcept {
  if (drawing_ns_ == 0) return 0.0;
  const double share =
      std::clamp(static_cast<double>(drawing_ns) / static_cast<double>(drawing_ns_), 0.0, 1.0);
  return share * static_cast<double>(moving_) / frames_per_second_;
}

}  // namespace felt
