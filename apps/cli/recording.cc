#include "recording.h"

#include "felt/io/events/event_reader.h"
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
  return session.import(event.time_ns, *import, *sketch);
}

/// Tells the newest recording that a drawing holds.
Result<void> tell_newest(const StoredDrawing& drawing, const std::string& folder,
                         Session& session) {
  const auto all = recordings_of(drawing);
  if (!all) return tl::unexpected(all.error());
  if (all->empty()) return fail(ErrorCode::kNotFound, "has no recording");
  return read_recording(drawing, all->size() - 1).and_then([&](const FeltRecording& recording) {
    return play_recording(recording, [&](const Event& e) { return tell(e, folder, session); });
  });
}

/// The same, and what is left of that drawing.
Result<OpenedDrawing> tell_drawing(const Input& input, const std::string& folder,
                                   Session& session) {
  Result<OpenedDrawing> opened = input.read_drawing({});
  if (!opened) return opened;
  if (auto told = tell_newest(opened->drawing, folder, session); !told) {
    return tl::unexpected(told.error());
  }
  StoredDrawing frame;
  frame.page = std::move(opened->drawing.page);
  frame.palette = std::move(opened->drawing.palette);
  frame.view = opened->drawing.view;
  opened->drawing = std::move(frame);
  return opened;
}

Result<void> tell_script(const Input& input, const std::string& folder, Session& session) {
  if (input.format() != FileFormat::kNdjson) {
    return fail(ErrorCode::kUnsupported,
                input.name() + ": is no script, which is .ndjson, and no drawing of Feltline");
  }
  ScriptSink sink;
  sink.event = [&](const Event& event) { return tell(event, folder, session); };
  return read_script(input.name(), input.reader(), sink);
}

}  // namespace

Result<OpenedDrawing> tell_recording(const std::string& path, Session& session) {
  const Result<Input> input = Input::open(path);
  if (!input) return fail(input.error().code, input_name(path) + ": " + input.error().message);
  const std::size_t slash = path.find_last_of('/');
  const std::string folder = slash == std::string::npos ? "" : path.substr(0, slash + 1);
  OpenedDrawing frame;
  if (input->format() == FileFormat::kFelt) {
    Result<OpenedDrawing> told = tell_drawing(*input, folder, session);
    if (!told) return tl::unexpected(with_context(told.error(), input->name()));
    frame = *std::move(told);
  } else if (Result<void> told = tell_script(*input, folder, session); !told) {
    return tl::unexpected(told.error());
  }
  if (Result<void> finished = session.finish(); !finished) {
    return tl::unexpected(finished.error());
  }
  return frame;
}

}  // namespace felt::cli
