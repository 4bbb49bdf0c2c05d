#pragma once

#include <QString>
#include <atomic>
#include <cstdint>
#include <optional>

#include "felt/base/result.h"
#include "felt/document/drawing.h"
#include "felt/io/import.h"
#include "felt/material/materials.h"
#include "felt/timelapse/timelapse_film.h"

namespace felt::desktop {

/// A film that the user asks for.
struct TimelapseRequest {
  /// The recording: an event script or a .felt drawing. Not read if `drawing` is set.
  QString recording;
  std::optional<Drawing> drawing{};  ///< a drawing with a recording in it
  Drawing start{.has_page = false};  ///< the drawing, and its page, on which a script begins
  Materials materials = Materials::built_in();  ///< those that a recording may name
  TimelapseFormat format = TimelapseFormat::kWebm;
  std::optional<double> seconds{};  ///< FilmLength::seconds
  int longer_px = 1280;             ///< the longer side, see film_size()
  bool grain = false;               ///< dry ink shows the grain of the surface; not in an .svg
  std::string program = "ffmpeg";   ///< FilmOptions::program
};

/// The progress of a film, which two threads share.
struct TimelapseProgress {
  std::atomic<bool> is_cancelled{false};      ///< set it to end the work; no file is written then
  std::atomic<std::int64_t> done{0}, all{0};  ///< frames; `all` is 0 until the first one
  /// What was changed or left out of the recording. Read it when make_timelapse() has returned.
  ImportReport report{};
};

/// Reads the recording, plays it and writes its film. Fails if the film would overwrite the
/// recording or a file that it imports, and like write_timelapse(). Messages name the file. Safe to
/// call from any thread.
Result<void> make_timelapse(const QString& path, const TimelapseRequest& request,
                            TimelapseProgress& progress);

}  // namespace felt::desktop
