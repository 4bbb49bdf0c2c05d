#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "felt/base/result.h"
#include "felt/document/drawing.h"
#include "felt/material/materials.h"
#include "felt/render/image.h"
#include "felt/render/page_painter.h"
#include "felt/replay/apply_recording.h"
#include "felt/session/session.h"
#include "felt/store/felt_recording.h"
#include "felt/timelapse/film_timing.h"

namespace felt {

/// A recording to make a film of. A function that plays it applies all its events, unchanged, to a
/// new session, so it always plays the same.
struct TimelapseSource {
  FeltRecording recording;
  /// The drawing before the first event. The recording of a .felt file begins with an empty page.
  Drawing start{.has_page = false};
  ReadImport read_import{};  ///< reads the files of import events
  Materials materials = Materials::built_in();
  /// If set, it is called before each event; if it returns true, the play fails with "cancelled".
  std::function<bool()> is_cancelled{};
};

/// What a recording contains, known before a film of it is made.
struct TimelapseSurvey {
  std::int64_t drawing_ns = 0;  ///< its length in DrawingTime
  bool has_moments = false;     ///< false if nothing in it can change the picture
  Rect ink;                     ///< everything that was on the page at any time; empty if nothing
  Drawing end;                  ///< the drawing at the end, with its surface and materials
};

/// Returns the length of a recording without playing it; only the first two members are set.
TimelapseSurvey measure_recording(const FeltRecording& recording);
/// Plays a recording and returns what it contains. Fails at an event that a session refuses.
Result<TimelapseSurvey> survey_recording(const TimelapseSource& source);

/// Returns the session on which a recording is played, before its first event. `on_edit` is
/// SessionOptions::on_edit.
Session session_of(const TimelapseSource& source, std::function<void(const Edit&)> on_edit);
/// Applies all events to that session, and ends the gesture in progress. Calls `before` before each
/// event. Fails if `before` does, and at an event that the session refuses.
Result<void> play_source(const TimelapseSource& source, Session& session,
                         const std::function<Result<void>(const Event&)>& before);

/// Receives the frames of a film. An error ends the play and is returned by it.
using FrameSink = std::function<Result<void>(const Image& frame)>;

/// Plays a recording and reports each frame of its film in order: FilmTiming::frames() times the
/// picture of the drawing at FilmTiming::at(), after all events up to that time. Ink and edits in
/// progress are shown. Each frame is equal, byte for byte, to render_page() of the drawing at that
/// moment (SessionPicture). The same recording gives the same frames. Memory does not depend on
/// the number of frames. Requires `page.area`. Fails like survey_recording(), and if the page is
/// invalid.
Result<void> play_timelapse(const TimelapseSource& source, const FilmTiming& timing,
                            const PageOptions& page, const FrameSink& sink);

/// Returns the options of a page that shows `area` as large as possible in a picture of this size,
/// in the middle. Fails if the area is empty or not finite, if a size is not positive, or if the
/// scale would be beyond the limits of PagePainter.
Result<PageOptions> page_in_frame(const Rect& area, int width_px, int height_px);

}  // namespace felt
