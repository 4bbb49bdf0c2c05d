#include <fmt/core.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <memory>

#include "commands.h"
#include "drawing_output.h"
#include "felt/io/events/event_writer.h"
#include "felt/replay/option_text.h"
#include "felt/replay/record_copy.h"
#include "felt/replay/record_run.h"
#include "felt/replay/replay_drawing.h"
#include "felt/session/recorder.h"
#include "felt/tools/tool.h"
#include "forces_file.h"
#include "interrupt.h"
#include "known_materials.h"
#include "overwrite_check.h"
#include "print.h"

namespace felt::cli {
namespace {

struct RecordArguments {
  std::string device;
  std::string output, to, events, forces;
  std::optional<double> seconds;
  std::string tool;
  std::vector<std::string> options;
  std::string page = "A4-landscape";
  double limit_n = 3.0;
  bool forces_on = false;
  bool yes = false;
};

constexpr const char* kConsent =
    "The device will push against the pen. Hold it loosely, and keep face and things away. Enter "
    "switches forces off and on, Ctrl-C ends.";

constexpr const char* kRecordExamples =
    "feltline record --device openhaptics:default -o sketch.felt\n"
    "feltline record --device haply:049D -o sketch.svg --forces-on --limit 1\n"
    "feltline record --device forcedimension:2 -o sketch.ndjson --events events.ndjson \\\n"
    "      --forces forces.csv --seconds 60 --set pencil.max_width_mm=3\n"
    "feltline replay events.ndjson --as-recorded -o again.svg";

/// The outputs of a recording other than the sketch.
struct RecordOutputs {
  std::optional<DrawingOutput> drawing;
  std::optional<Output> events;
  std::optional<ForcesFile> forces;
  Result<void> written = {};  ///< result of writing the events so far
};

Result<RecordOutputs> open_outputs(const RecordArguments& args, const Rect& page) {
  RecordOutputs outputs;
  const Result<Format> format = output_format(args.output, args.to);
  if (!format) throw UsageError(format.error().message);
  PictureOptions picture;
  picture.area = page;
  Result<DrawingOutput> drawing = DrawingOutput::create(args.output, *format, picture);
  if (!drawing) return tl::unexpected(drawing.error());
  outputs.drawing.emplace(*std::move(drawing));
  if (!args.events.empty()) {
    Result<Output> events = Output::create(args.events);
    if (!events) return tl::unexpected(events.error());
    outputs.events.emplace(*std::move(events));
  }
  if (!args.forces.empty()) {
    Result<ForcesFile> forces = ForcesFile::create(args.forces);
    if (!forces) return tl::unexpected(forces.error());
    outputs.forces.emplace(*std::move(forces));
  }
  return outputs;
}

Recorder::Sink event_sink(RecordOutputs& outputs) {
  return [&outputs](std::span<const Event> events) {
    if (!outputs.events || !outputs.written) return;
    std::string lines;
    for (const Event& event : events) append_event_line(lines, event);
    outputs.written = outputs.events->write(lines);
  };
}

void set_options(const RecordArguments& args, Session& session) {
  const auto apply = [&session](const char* from, const Event& event) {
    if (const Result<void> done = session.apply(event); !done) {
      throw UsageError(std::string(from) + ": " + done.error().message);
    }
  };
  if (!args.tool.empty()) apply("--tool", {0, SelectTool{args.tool}});
  for (const std::string& option : args.options) {
    const Result<SetOption> event = option_event(session, option);
    if (!event) throw UsageError("--set: " + event.error().message);
    apply("--set", {0, *event});
  }
}

/// Writes the drawing to another file. Called if its own file cannot be written, because the
/// drawing would otherwise be lost.
Result<void> rescue(const Error& error, Drawing drawing) {
  std::error_code none;
  const std::string path = std::filesystem::temp_directory_path(none).string() +
                           "/feltline-record-" + std::to_string(getpid()) + ".felt";
  Result<DrawingOutput> other = DrawingOutput::create(path, Format::kFelt, PictureOptions());
  const bool saved = other && other->write(std::move(drawing));
  return fail(error.code, error.message + (saved ? "; the drawing is in " + path : ""));
}

Result<void> write_outputs(RecordOutputs& outputs, Recorder& recorder, const Session& session) {
  Drawing drawing = drawing_after({.has_page = false}, session, session.document());
  if (Result<void> done = outputs.drawing->write(drawing); !done) {
    return rescue(done.error(), std::move(drawing));
  }
  recorder.flush();
  if (outputs.events) {
    if (!outputs.written) return outputs.written;
    if (Result<void> done = outputs.events->commit(); !done) return done;
  }
  return outputs.forces ? outputs.forces->finish() : Result<void>();
}

bool agrees_to_forces(const RecordArguments& args) {
  if (args.yes) return true;
  say("{}\n", kConsent);
  return ask("Do you agree?");
}

/// Ends the program without destructors and exit handlers. Used if one of our threads is stuck in a
/// call of a vendor's library: the thread still uses the objects that would be destroyed, and exit
/// handlers of the library may wait for that thread forever.
[[noreturn]] void end_at_once() {
  std::fflush(stdout);
  std::fflush(stderr);
  _exit(EXIT_FAILURE);
}

const char* state_words(SafetyState state) {
  switch (state) {
    case SafetyState::kOff:
      return "forces off";
    case SafetyState::kWaiting:
      return "lift the pen to start the forces";
    case SafetyState::kEngaging:
      return "forces begin";
    case SafetyState::kActive:
      return "forces on";
    case SafetyState::kSilent:
      return "damping only";
    case SafetyState::kFalling:
      return "forces fading out";
    case SafetyState::kLatched:
      return "forces off after a fault";
  }
  return "";
}

std::string status_line(const RecordStatus& status) {
  return fmt::format("{:.0f} Hz  {:.2f} N  {}  {} strokes  (Enter: forces {}, Ctrl-C: end)",
                     status.rate_hz, status.sent_n, state_words(status.state), status.strokes,
                     status.wants_forces ? "off" : "on");
}

/// Returns the recording's options. `console`, `outputs` and `copy` must outlive them.
RecordOptions record_options(const RecordArguments& args, const Rect& page, Console& console,
                             RecordOutputs& outputs, RecordCopy& copy) {
  RecordOptions options{.page = page,
                        .force_limit_n = args.limit_n,
                        .forces = args.forces_on,
                        .seconds = args.seconds,
                        .is_over = Interrupt::was_asked,
                        .wants_pause = Interrupt::wants_pause,
                        .has_agreed = args.yes,
                        .enter_pressed = enter_pressed};
  options.pause = [&console] {
    console.end_progress();
    Interrupt::pause();
  };
  options.may_move = [asks = !args.yes](const std::string& instructions) {
    say("{}\n", instructions);
    return !asks || ask("Ready?");
  };
  // The text is not printed as a notice, because --quiet hides notices, and the user must see the
  // text before agreeing.
  options.ask_consent = [&console] {
    console.end_progress();
    say("{}\nEnter again: you agree to forces.\n", kConsent);
  };
  options.on_notice = [&console](const std::string& words) { console.notice(words); };
  options.on_status = [&console](const RecordStatus& s) { console.status(status_line(s)); };
  options.on_tick = [&outputs](const TickReport& tick) {
    return outputs.forces ? outputs.forces->add(tick, tick.sample.pressure) : Result<void>();
  };
  options.keep = [&copy](const Session& session) { copy.keep(session); };
  return options;
}

void run_record(const RecordArguments& args, Console& console) {
  check_no_overwrite(
      {}, {{"-o", args.output}, {"--events", args.events}, {"--forces", args.forces}}, console);
  const Result<std::optional<Rect>> page = parse_page(args.page);
  if (!page || !*page) throw UsageError("--page: '" + args.page + "' is not a page size");
  const std::vector<std::unique_ptr<Driver>> drivers = make_drivers();
  const Result<RealDevice> device = find_real_device(drivers, args.device);
  if (!device) return console.error(device.error().message);
  Result<RecordOutputs> outputs = open_outputs(args, **page);
  if (!outputs) return console.error(outputs.error().message);
  Recorder recorder(event_sink(*outputs));
  RecordCopy copy(args.output);
  Session session(make_tools(), {.device = {},
                                 .materials = known_materials(console).materials,
                                 .document = {},
                                 .on_event = std::ref(recorder),
                                 .on_edit = [&copy](const Edit&) { copy.note_edit(); }});
  set_options(args, session);
  if (args.forces_on && !agrees_to_forces(args)) {
    return console.error("you did not agree to forces; omit --forces-on to draw without them");
  }
  const Interrupt interrupt(OnSuspend::kPause);
  RecordRun run(*device, session, record_options(args, **page, console, *outputs, copy));
  if (Result<void> begun = run.begin(); !begun) return console.error(begun.error().message);
  const Result<void> drawn = run.draw();
  console.end_progress();
  if (!drawn) console.error(drawn.error().message);
  if (Result<void> written = write_outputs(*outputs, recorder, session); !written) {
    console.error(written.error().message);
  } else {
    copy.remove();
    console.summary(
        fmt::format("{} strokes in {}", session.document().stroke_count(), args.output));
  }
  if (run.hangs()) end_at_once();
}

void add_options(CLI::App& command, RecordArguments& args) {
  command
      .add_option("--device", args.device, "The id of the device, as 'feltline devices' lists it")
      ->required();
  command
      .add_option("-o,--output", args.output,
                  "Output file: .felt, .ndjson, .svg, .pdf, .png; '-' is stdout")
      ->required();
  command.add_option("--to", args.to, "Output format; the default is set by the file extension");
  command.add_option("--events", args.events,
                     "Save all events, for 'feltline replay --as-recorded', .ndjson");
  command.add_option(
      "--forces", args.forces,
      "Save pose and forces, about 250 rows a second, as .csv like 'replay --forces'");
  command.add_option("--seconds", args.seconds, "Stop after this time")
      ->check(number_between(0.1, 86'400.0));
  command.add_option("--tool", args.tool, "The tool to use (see 'feltline tools')");
  command.add_option("--set", args.options, "TOOL.OPTION=VALUE")->allow_extra_args(false);
  command
      .add_option("--page", args.page,
                  "Size of the page: A4, A4-landscape, WxH in mm. Its centre is the centre of the "
                  "device's reach, unless the plane was calibrated in feltline-desktop")
      ->capture_default_str();
  command.add_flag("--forces-on", args.forces_on,
                   "Forces from the start, after you agreed; without it the pen is free");
  add_force_limit(command, args.limit_n);
  command.add_flag("--yes", args.yes, "Do not ask: you agree to forces, and that the arm may move");
}

}  // namespace

void add_record_command(CLI::App& app, Console& console) {
  CLI::App* command = app.add_subcommand(
      "record", "Draw with a real device, without a window, and save the sketch");
  const auto args = std::make_shared<RecordArguments>();
  add_options(*command, *args);
  command->footer(
      "While you draw, Enter switches forces off and on, and Ctrl-C ends and saves. If the device\n"
      "is disconnected, the ink so far is kept, and drawing continues when it is connected again;\n"
      "forces stay off until you press Enter. Every few seconds a copy is saved in\n"
      "OUTPUT.unsaved-NUMBER.ndjson, including the stroke in progress. It remains only after a\n"
      "crash; 'feltline recover' finds it.\n" +
      examples(kRecordExamples));
  command->callback([args, &console] { run_record(*args, console); });
}

}  // namespace felt::cli
