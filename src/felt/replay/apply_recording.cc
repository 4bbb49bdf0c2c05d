#include "felt/replay/apply_recording.h"

#include <utility>

#include "felt/io/events/event_reader.h"
#include "felt/store/felt_recording.h"

namespace felt {

Result<void> apply_event(const Event& event, const ReadImport& read_import, Session& session) {
  const auto* import = std::get_if<ImportEvent>(&event.what);
  if (!import) return session.apply(event);
  const Result<VisibleInk> ink = read_import(import->path);
  if (!ink) return tl::unexpected(ink.error());
  return session.import(event.time_ns, *import, ink->strokes, ink->fills);
}

Result<void> apply_script(const std::string& name, ReadBytes read, const ReadImport& read_import,
                          Session& session) {
  ScriptSink sink;
  sink.event = [&](const Event& event) { return apply_event(event, read_import, session); };
  if (Result<void> done = read_script(name, std::move(read), sink); !done) return done;
  return session.finish();
}

Result<void> apply_recording(const Drawing& drawing, const ReadImport& read_import,
                             Session& session) {
  const auto all = recordings_of(drawing);
  if (!all) return tl::unexpected(all.error());
  if (all->empty()) return fail(ErrorCode::kNotFound, "has no recording");
  const Result<FeltRecording> recording = read_recording(drawing, all->size() - 1);
  if (!recording) return tl::unexpected(recording.error());
  Result<void> done = play_recording(
      *recording, [&](const Event& event) { return apply_event(event, read_import, session); });
  return done ? session.finish() : done;
}

}  // namespace felt
