#include "felt/timelapse/timelapse.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "felt/document/visible_strokes.h"
#include "felt/replay/replay_drawing.h"
#include "felt/timelapse/drawing_time.h"
#include "felt/timelapse/session_picture.h"
#include "felt/tools/tool.h"

namespace felt {
namespace {

constexpr double kMaxDpi = 100'000.0;  // PagePainter

/// Adds the ink that an edit puts on the page.
void add_ink_of(const Edit& edit, Rect& ink) {
  for (const StrokeChange& c : edit.changes) {
    if (c.after) ink.extend(c.after->bounds());
  }
  for (const FillChange& c : edit.fills) {
    if (c.after) ink.extend(fill_bounds(*c.after));
  }
  for (const LayerChange& c : edit.layers) {
    if (c.after && c.after->picture && c.after->picture->exported) {
      ink.extend(bounds_of(*c.after->picture));
    }
  }
}

}  // namespace

TimelapseSurvey measure_recording(const FeltRecording& recording) {
  DrawingTime time;
  (void)play_recording(recording, [&time](const Event& event) -> Result<void> {
    time.at(event);
    return {};
  });
  TimelapseSurvey survey;
  survey.drawing_ns = time.now_ns();
  survey.has_moments = time.has_begun();
  return survey;
}

Session session_of(const TimelapseSource& source, std::function<void(const Edit&)> on_edit) {
  SessionOptions options;
  options.materials = source.materials;
  options.document = source.start.document;
  options.on_edit = std::move(on_edit);
  return Session(make_tools(), std::move(options));
}

Result<void> play_source(const TimelapseSource& source, Session& session,
                         const std::function<Result<void>(const Event&)>& before) {
  for (const auto& [id, value] : options_of(source.start, session.materials())) {
    if (Result<void> set = session.apply({0, SetOption{id, value}}); !set) return set;
  }
  const Result<void> done =
      play_recording(source.recording, [&](const Event& event) -> Result<void> {
        if (source.is_cancelled && source.is_cancelled()) return fail(ErrorCode::kIo, "cancelled");
        if (Result<void> ok = before(event); !ok) return ok;
        return apply_event(event, source.read_import, session);
      });
  return done ? session.finish() : done;
}

Result<TimelapseSurvey> survey_recording(const TimelapseSource& source) {
  TimelapseSurvey survey;
  survey.ink = ink_bounds(source.start.document);
  Session session =
      session_of(source, [&survey](const Edit& edit) { add_ink_of(edit, survey.ink); });
  DrawingTime time;
  const Result<void> done =
      play_source(source, session, [&time](const Event& event) -> Result<void> {
        time.at(event);
        return {};
      });
  if (!done) return tl::unexpected(done.error());
  survey.drawing_ns = time.now_ns();
  survey.has_moments = time.has_begun();
  survey.end = drawing_after(source.start, session, session.document());
  return survey;
}

Result<void> play_timelapse(const TimelapseSource& source, const FilmTiming& timing,
                            const PageOptions& page, const FrameSink& sink) {
  const auto picture = SessionPicture::create(page, source.start.document);
  if (!picture) return tl::unexpected(picture.error());
  Result<void> applied;
  Session session = session_of(source, [&](const Edit& edit) {
    if (applied) applied = (*picture)->apply(edit);
  });
  DrawingTime time;
  std::int64_t next = 0;
  const auto report = [&]() -> Result<void> {
    ++next;
    if (!applied) return applied;
    const Result<const Image*> frame = (*picture)->update(session);
    return frame ? sink(**frame) : tl::unexpected(frame.error());
  };
  Result<void> done = play_source(source, session, [&](const Event& event) -> Result<void> {
    const std::int64_t now_ns = time.at(event);
    while (next < timing.frames() && timing.at(next) < now_ns) {
      if (Result<void> ok = report(); !ok) return ok;
    }
    return {};
  });
  while (done && next < timing.frames()) done = report();
  return done;
}

Result<PageOptions> page_in_frame(const Rect& area, int width_px, int height_px) {
  if (width_px <= 0 || height_px <= 0 || area.empty() || !std::isfinite(area.width()) ||
      !std::isfinite(area.height())) {
    return fail(ErrorCode::kInvalidArgument, "the area to show is empty or not finite");
  }
  // A point or a line is shown as if it were 1 mm wide and high.
  const double px_per_mm =
      std::min(width_px / std::max(area.width(), 1.0), height_px / std::max(area.height(), 1.0));
  PageOptions page;
  page.dpi = kMmPerInch * px_per_mm;
  if (!(page.dpi > 0.0 && page.dpi <= kMaxDpi)) {
    return fail(ErrorCode::kInvalidArgument, "the area to show is too large or too small");
  }
  const double width_mm = width_px / px_per_mm, height_mm = height_px / px_per_mm;
  const double x0 = 0.5 * (area.x0 + area.x1 - width_mm);
  const double y0 = 0.5 * (area.y0 + area.y1 - height_mm);
  page.area = Rect{x0, y0, x0 + width_mm, y0 + height_mm};
  return page;
}

}  // namespace felt
