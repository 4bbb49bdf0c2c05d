#include "felt/timelapse/timelapse_input.h"

#include <cstdint>
#include <utility>
#include <variant>

#include "felt/formats/drawing_materials.h"
#include "felt/io/events/event_reader.h"
#include "felt/replay/replay_drawing.h"
#include "felt/replay/script_run.h"

namespace felt {
namespace {

constexpr std::int64_t kScriptPeriodNs = 1'000'000;  // of recordings that do not say it

/// Reads a script whose pen samples are drawn unchanged. Returns false, and an incomplete
/// recording, if a hand must draw it.
Result<bool> read_recorded(const TimelapseScript& script, FeltRecording& recording) {
  FeltRecorder recorder("", kScriptPeriodNs);
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
  const Result<void> done = read_script(script.name, read_text(script.text), sink);
  recording = recorder.take();
  if (needs_hand) return false;
  if (!done) return tl::unexpected(done.error());
  return true;
}

/// Lets the simulated hand draw a script, and records it.
Result<FeltRecording> record_script(const TimelapseScript& script, const TimelapseSource& source,
                                    ImportReport& report) {
  ReplaySettings settings = script.pen;
  settings.materials = source.materials;
  FeltRecorder recorder(std::string(settings.device.name), kScriptPeriodNs);
  recorder.event({0, UseDevice{settings.device.capabilities}});
  ReplayMachine machine(settings, source.start.document,
                        {.event = [&recorder](const Event& event) { recorder.event(event); }});
  for (const auto& [id, value] : options_of(source.start, source.materials)) {
    if (Result<void> set = machine.set_option(id, value); !set) {
      return tl::unexpected(set.error());
    }
  }
  ScriptRun run(machine, 1.0, 0);
  Result<void> done = run.script(script.name, script.folder, read_text(script.text));
  report = run.report();
  if (done) done = run.play();
  if (!done) return tl::unexpected(done.error());
  return recorder.take();
}

}  // namespace

Result<bool> use_script(const TimelapseScript& script, TimelapseInput& input) {
  const Result<bool> is_recorded = read_recorded(script, input.source.recording);
  if (!is_recorded || *is_recorded) return is_recorded;
  Result<FeltRecording> drawn = record_script(script, input.source, input.report);
  if (!drawn) return tl::unexpected(drawn.error());
  input.source.recording = *std::move(drawn);
  return false;
}

Result<void> use_newest_recording(const std::string& name, const Drawing& drawing,
                                  TimelapseInput& input) {
  const auto all = recordings_of(drawing);
  if (!all) return tl::unexpected(with_context(all.error(), name));
  if (all->empty()) {
    return fail(ErrorCode::kNotFound,
                name +
                    ": has no recording of how it was drawn. 'feltline replay --recording' saves "
                    "one; 'feltline-desktop --record' writes one as .ndjson");
  }
  Result<FeltRecording> recording = read_recording(drawing, all->size() - 1);
  if (!recording) return tl::unexpected(with_context(recording.error(), name));
  input.source.recording = *std::move(recording);
  input.source.materials = with_texts(drawing.materials, std::move(input.source.materials));
  input.frame.page = drawing.page;
  input.frame.has_page = drawing.has_page;
  return {};
}

Result<void> check_has_moments(const std::string& name, const TimelapseInput& input) {
  if (measure_recording(input.source.recording).has_moments) return {};
  return fail(ErrorCode::kInvalidData, name + ": nothing is drawn in it");
}

}  // namespace felt
