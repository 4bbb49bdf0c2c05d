#include "timelapse_input.h"

#include <algorithm>
#include <array>
#include <utility>

#include "felt/formats/drawing_materials.h"
#include "felt/io/events/event_reader.h"
#include "felt/replay/replay_drawing.h"
#include "felt/replay/script_run.h"
#include "felt/timelapse/timelapse.h"
#include "input.h"
#include "known_materials.h"
#include "replay_arguments.h"
#include "replay_input.h"

namespace felt::cli {
namespace {

constexpr std::size_t kMaxScriptBytes = std::size_t{2} << 30;  // as kMaxFeltBytes
constexpr std::int64_t kPeriodNs = 1'000'000;                  // of recordings that do not say it

Result<std::string> read_text_of(const Input& input) {
  std::string text;
  const ReadBytes read = input.reader();
  std::array<char, std::size_t{1} << 16> block{};
  for (;;) {
    const Result<std::size_t> count = read(block);
    if (!count) return tl::unexpected(with_context(count.error(), input.name()));
    if (*count == 0) return text;
    text.append(block.data(), *count);
    if (text.size() > kMaxScriptBytes) {
      return fail(ErrorCode::kLimitExceeded, input.name() + ": is larger than 2 GiB");
    }
  }
}

/// Reads a script whose pen samples are drawn unchanged. Returns false, and an incomplete
/// recording, if a hand must draw it.
Result<bool> read_recorded(const std::string& name, const std::string& text,
                           FeltRecording& recording) {
  FeltRecorder recorder("", kPeriodNs);
  bool needs_hand = false;
  const auto stop = [&needs_hand] {
    needs_hand = true;
    return fail(ErrorCode::kUnsupported, "needs a hand");
  };
  ScriptSink sink;
  sink.event = [&](const Event& event) -> Result<void> {
    if (std::holds_alternative<HandEvent>(event.what)) return stop();
    recorder.event(event);
    return {};
  };
  sink.stroke = [&](const RawStroke&) -> Result<void> { return stop(); };
  const Result<void> done = read_script(name, read_text(text), sink);
  recording = recorder.take();
  if (needs_hand) return false;
  if (!done) return tl::unexpected(done.error());
  return true;
}

/// Lets the simulated hand draw a script, and records it.
Result<FeltRecording> record_script(const std::string& name, const std::string& text,
                                    const TimelapseSource& source) {
  const ReplayArguments pen;
  ReplaySettings settings = pen.settings();
  settings.materials = source.materials;
  FeltRecorder recorder(pen.device, kPeriodNs);
  recorder.event({0, UseDevice{settings.device.capabilities}});
  ReplayMachine machine(settings, source.start.document,
                        {.event = [&recorder](const Event& event) { recorder.event(event); }});
  for (const auto& [id, value] : options_of(source.start, source.materials)) {
    if (Result<void> set = machine.set_option(id, value); !set) {
      return tl::unexpected(set.error());
    }
  }
  ScriptRun run(machine, 1.0, 0);
  Result<void> done = run.script(name, folder_of(name), read_text(text));
  if (done) done = run.play();
  if (!done) return tl::unexpected(done.error());
  return recorder.take();
}

Result<void> read_script_input(const Input& input, const TimelapseFiles& files,
                               TimelapseInput& timelapse) {
  const Result<std::string> text = read_text_of(input);
  if (!text) return tl::unexpected(text.error());
  timelapse.source.read_import = reads_imports(files.input, {files.output});
  const Result<bool> is_recorded = read_recorded(input.name(), *text, timelapse.source.recording);
  if (!is_recorded) return tl::unexpected(is_recorded.error());
  if (*is_recorded) return {};
  timelapse.source.read_import = reads_imports("", {files.output});  // its paths are resolved
  Result<FeltRecording> drawn = record_script(input.name(), *text, timelapse.source);
  if (!drawn) return tl::unexpected(drawn.error());
  timelapse.source.recording = *std::move(drawn);
  return {};
}

Result<void> read_drawing_input(const Input& input, const TimelapseFiles& files,
                                TimelapseInput& timelapse) {
  const Result<Imported> opened = input.read_drawing({});
  if (!opened) return tl::unexpected(with_context(opened.error(), input.name()));
  const Drawing& drawing = opened->drawing;
  const auto all = recordings_of(drawing);
  if (!all) return tl::unexpected(with_context(all.error(), input.name()));
  if (all->empty()) {
    return fail(ErrorCode::kNotFound,
                input.name() +
                    ": has no recording of how it was drawn. 'feltline replay --recording' saves "
                    "one; 'feltline-desktop --record' writes one as .ndjson");
  }
  Result<FeltRecording> recording = read_recording(drawing, all->size() - 1);
  if (!recording) return tl::unexpected(with_context(recording.error(), input.name()));
  timelapse.source.recording = *std::move(recording);
  timelapse.source.materials = with_texts(drawing.materials, std::move(timelapse.source.materials));
  timelapse.source.read_import = reads_imports(files.input, {files.output});
  timelapse.frame.page = drawing.page;
  timelapse.frame.has_page = drawing.has_page;
  return {};
}

}  // namespace

Result<TimelapseInput> read_timelapse(const TimelapseFiles& files, Console& console) {
  const std::string& on = files.on;
  const Result<Input> input = Input::open(files.input);
  if (!input) return tl::unexpected(with_context(input.error(), input_name(files.input)));
  TimelapseInput timelapse;
  timelapse.frame.has_page = false;
  timelapse.source.materials = known_materials(console).materials;
  if (!on.empty()) {
    Result<Drawing> start = read_start(on);
    if (!start) return tl::unexpected(start.error());
    timelapse.source.materials =
        with_texts(start->materials, std::move(timelapse.source.materials));
    timelapse.frame.page = start->page;
    timelapse.frame.has_page = start->has_page;
    timelapse.source.start = *std::move(start);
  }
  Result<void> done;
  if (input->format() == FileFormat::kFelt) {
    if (!on.empty()) {
      return fail(ErrorCode::kUnsupported,
                  input->name() +
                      ": --on is for scripts; the recording of a .felt file begins with "
                      "an empty page");
    }
    done = read_drawing_input(*input, files, timelapse);
  } else if (input->format() == FileFormat::kNdjson) {
    done = read_script_input(*input, files, timelapse);
  } else {
    return fail(ErrorCode::kUnsupported,
                input->name() + ": neither an event script (.ndjson) nor a .felt file");
  }
  if (!done) return tl::unexpected(done.error());
  if (!measure_recording(timelapse.source.recording).has_moments) {
    return fail(ErrorCode::kInvalidData, input->name() + ": nothing is drawn in it");
  }
  return timelapse;
}

}  // namespace felt::cli
