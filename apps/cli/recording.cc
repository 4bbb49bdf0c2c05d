#include "recording.h"

#include "felt/io/event_reader.h"
#include "felt/store/felt_recording.h"
#include "input.h"
#include "replay_machine.h"

namespace felt::cli {
namespace {

Result<void> tell(const Event& event, const std::string& folder, Session& session) {
  const auto* import = std::get_if<ImportEvent>(&event.what);
  if (!import) return session.apply(event);
  const bool is_absolute = import->path.rfind('/', 0) == 0;
  const Result<Sketch> sketch = read_sketch(is_absolute ? import->path : folder + import->path);
  if (!sketch) return tl::unexpected(sketch.error());
  return session.import(event.time_ns, import->path, *sketch);
}

/// The newest recording that a drawing holds.
Result<FeltRecording> recording_in(const Input& input) {
  const Result<OpenedDrawing> opened = input.read_drawing({});
  if (!opened) return tl::unexpected(opened.error());
  const auto all = recordings_of(opened->drawing);
  if (!all) return tl::unexpected(all.error());
  if (all->empty()) return fail(ErrorCode::kNotFound, "has no recording");
  return read_recording(opened->drawing, all->size() - 1);
}

}  // namespace

Result<void> tell_recording(const std::string& path, Session& session) {
  const Result<Input> input = Input::open(path);
  if (!input) return fail(input.error().code, input_name(path) + ": " + input.error().message);
  const std::size_t slash = path.find_last_of('/');
  const std::string folder = slash == std::string::npos ? "" : path.substr(0, slash + 1);
  if (input->format() == FileFormat::kFelt) {
    const Result<void> told = recording_in(*input).and_then([&](const FeltRecording& recording) {
      return play_recording(recording, [&](const Event& e) { return tell(e, folder, session); });
    });
    if (!told) return tl::unexpected(with_context(told.error(), input->name()));
    return session.finish();
  }
  if (input->format() != FileFormat::kNdjson) {
    return fail(ErrorCode::kUnsupported,
                input->name() + ": is no script, which is .ndjson, and no drawing of Feltline");
  }
  ScriptSink sink;
  sink.event = [&](const Event& event) { return tell(event, folder, session); };
  if (Result<void> read = read_script(input->name(), input->reader(), sink); !read) return read;
  return session.finish();
}

}  // namespace felt::cli
