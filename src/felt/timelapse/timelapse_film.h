#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "felt/base/result.h"
#include "felt/film/film_writer.h"
#include "felt/render/grain.h"
#include "felt/timelapse/film_timing.h"
#include "felt/timelapse/timelapse.h"

namespace felt {

/// The file types of a film of a recording.
enum class TimelapseFormat : std::uint8_t { kWebm, kGif, kSvg };

/// Returns the format by the ending of a name, in any case; nullopt if it is no film.
std::optional<TimelapseFormat> timelapse_format_of(const std::string& path);

/// Room between the ink and the edge of a film that shows everything that was drawn.
inline constexpr double kFilmMarginMm = 5.0;

struct FilmSize {
  int width_px = 0, height_px = 0;
};
/// Returns the size of a film of an area whose longer side is `longer_px` long. The other side is
/// even, because many players need that, and at least FilmOptions::kMinSidePx.
FilmSize film_size(int longer_px, const Rect& area);

/// Everything that is known before the first frame of a film.
struct TimelapseFilm {
  TimelapseFormat format = TimelapseFormat::kWebm;
  FilmLength length{};
  Rect area;  ///< the part of the page that it shows
  FilmSize size;
  Rgba paper{255, 255, 255, 255};  ///< opaque, unless the format is kSvg
  Grain grain{};                   ///< an .svg shows none
  /// Called after each frame with the number of frames so far and of all. May be null.
  std::function<void(std::int64_t done, std::int64_t all)> on_frame{};
  std::string program = "ffmpeg";  ///< FilmOptions::program
};

/// Plays a recording and writes its film. The file gets its name when it is complete; after an
/// error, the previous file of that name stays. `survey` is that of the recording; a GIF needs
/// TimelapseSurvey::end. Fails like play_timelapse(), animated_svg() and FilmWriter, and with
/// "PATH: cancelled" if `source.is_cancelled` is set and returns true. Messages about the recording
/// begin with `name`.
Result<void> write_timelapse(const std::string& path, const std::string& name,
                             const TimelapseSource& source, const TimelapseSurvey& survey,
                             const TimelapseFilm& film);

}  // namespace felt
