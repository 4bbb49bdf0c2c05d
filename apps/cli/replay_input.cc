#include "replay_input.h"

#include <fmt/core.h>

#include <utility>

#include "felt/document/visible_strokes.h"
#include "felt/formats/line_drawing.h"
#include "felt/replay/apply_recording.h"
#include "felt/replay/guarded_imports.h"
#include "input.h"

namespace felt::cli {
namespace {

constexpr std::size_t kBatchBytes = std::size_t{64} << 10;

tl::unexpected<Error> input_error(const std::string& path, const Error& error) {
  return fail(error.code, input_name(path) + ": " + error.message);
}

/// Reads an input that does not consist of lines with strokes.
Result<Drawing> read_whole(const Input& input) {
  Result<Imported> opened = input.read_drawing({});
  if (opened) return std::move(opened->drawing);
  return fail(opened.error().code, input.name() + ": " + opened.error().message);
}

/// Reads lines of strokes. Any invalid line is an error, because a script depends on all strokes.
Result<std::vector<StrokePtr>> read_lines(const Input& input) {
  LineReader reader(input.reader());
  LineBatch batch;
  LineStrokes lines;
  std::vector<StrokePtr> strokes;
  for (;;) {
    const Result<bool> more = reader.fill(batch, kBatchBytes);
    if (!more) return fail(more.error().code, input.name() + ": " + more.error().message);
    if (!*more) return strokes;
    for (std::size_t i = 0; i < batch.size(); ++i) {
      const NdjsonLine line = batch.line(i);
      Result<std::optional<NamedStroke>> stroke = lines.read(line);
      if (!stroke) {
        return fail(stroke.error().code,
                    fmt::format("{}:{}: {}", input.name(), line.number(), stroke.error().message));
      }
      if (*stroke) strokes.push_back(std::make_shared<const Stroke>(std::move((*stroke)->stroke)));
    }
  }
}

/// Applies the newest recording in a drawing to the session. Returns the drawing's page, palette
/// and view, which the recording does not contain.
Result<Drawing> apply_drawing(const Input& input, const ReadImport& read_import, Session& session) {
  const Result<Imported> opened = input.read_drawing({});
  if (!opened) return tl::unexpected(with_context(opened.error(), input.name()));
  if (auto done = apply_recording(opened->drawing, read_import, session); !done) {
    return tl::unexpected(with_context(done.error(), input.name()));
  }
  Drawing frame;
  frame.page = opened->drawing.page;
  frame.palette = opened->drawing.palette;
  frame.view = opened->drawing.view;
  return frame;
}

}  // namespace

Result<Drawing> read_start(const std::string& path) {
  const Result<Input> input = Input::open(path);
  if (!input) return input_error(path, input.error());
  if (!input->is_lines()) return read_whole(*input);
  return read_lines(*input).map([](const std::vector<StrokePtr>& strokes) {
    return Drawing{.document = document_of(strokes), .has_page = false};
  });
}

Result<VisibleInk> read_strokes(const std::string& path) {
  const Result<Input> input = Input::open_regular(path);
  if (!input) return input_error(path, input.error());
  if (input->is_lines())
    return read_lines(*input).map([](std::vector<StrokePtr> strokes) {
      return VisibleInk{std::move(strokes), {}};
    });
  return read_whole(*input).map(
      [](const Drawing& drawing) { return visible_ink(drawing.document); });
}

std::string folder_of(const std::string& path) {
  return path.substr(0, path.find_last_of('/') + 1);
}

ReadImport reads_imports(const std::string& script, std::vector<std::string> outputs) {
  return guarded_imports(folder_of(script), std::move(outputs), read_strokes);
}

Result<void> read_script_file(const std::string& path, ScriptRun& run) {
  const Result<Input> input = Input::open(path);
  if (!input) return input_error(path, input.error());
  if (input->format() != FileFormat::kNdjson) {
    return fail(ErrorCode::kUnsupported, input->name() + ": not an event script (.ndjson)");
  }
  return run.script(input->name(), folder_of(path), input->reader());
}

Result<Drawing> apply_recording_file(const std::string& path, Session& session) {
  const Result<Input> input = Input::open(path);
  if (!input) return input_error(path, input.error());
  const ReadImport read_import = reads_imports(path, {});
  if (input->format() == FileFormat::kFelt) return apply_drawing(*input, read_import, session);
  if (input->format() != FileFormat::kNdjson) {
    return fail(ErrorCode::kUnsupported,
                input->name() + ": neither an event script (.ndjson) nor a .felt file");
  }
  if (Result<void> done = apply_script(input->name(), input->reader(), read_import, session);
      !done) {
    return tl::unexpected(done.error());
  }
  return Drawing{.has_page = false};
}

}  // namespace felt::cli
