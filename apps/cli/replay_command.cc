#include <fmt/core.h>

#include <chrono>
#include <cmath>
#include <memory>
#include <utility>
#include <variant>
#include <vector>

#include "commands.h"
#include "drawing_output.h"
#include "felt/formats/drawing_materials.h"
#include "felt/io/limits.h"
#include "felt/io/picture/png.h"
#include "felt/replay/replay_drawing.h"
#include "felt/replay/script_run.h"
#include "felt/session/session_medium.h"
#include "felt/store/felt_recording.h"
#include "felt/stroke/color_text.h"
#include "force_plot.h"
#include "forces_file.h"
#include "input.h"
#include "known_materials.h"
#include "overlay_picture.h"
#include "overwrite_check.h"
#include "picture.h"
#include "print.h"
#include "replay_arguments.h"
#include "replay_input.h"
#include "replay_sound.h"
#include "sketch_input.h"

namespace felt::cli {
namespace {

constexpr double kPlotDpi = 192.0;  // two pixels per unit, 96 units per inch

/// The options and arguments of the command line.
struct ReplayCommandArguments {
  std::vector<std::string> scripts;
  std::string output, to;
  std::string on;
  std::string forces, plot, sound, stats;
  ReplayArguments pen;
  std::uint64_t seed = 0;
  /// Id of the surface to draw on if it is not `picture.surface`: the surface in a file, or that of
  /// a former flag, which did not change the picture.
  std::string page_surface;
  std::string medium;
  std::vector<std::string> options;
  double mm_per_unit = 1.0;
  std::optional<double> until_ms;
  bool overlay = false;
  bool as_recorded = false;
  bool recording = false;
  PictureArguments picture;
};

constexpr const char* kReplayExamples =
    "feltline replay strokes.ndjson -o sketch.svg --forces forces.csv --plot forces.png\n"
    "feltline replay events.ndjson --on sketch.ndjson -o - | feltline info -\n"
    "feltline replay events.ndjson --until 2500 --overlay -o work.png\n"
    "feltline replay recording.ndjson --as-recorded -o sketch.svg\n"
    "feltline replay strokes.ndjson --surface canvas --medium chalk --sound rubbing.wav\n"
    "feltline replay strokes.ndjson --recording -o sketch.felt\n"
    "feltline replay strokes.ndjson --device premium --hand light --set pencil.snap=off \\\n"
    "      --stats json";

void add_output_options(CLI::App& command, ReplayCommandArguments& args) {
  command
      .add_option("EVENTS", args.scripts,
                  "Event scripts, raw pen strokes, or files with both, .ndjson; '-' is stdin")
      ->required();
  command.add_option("-o,--output", args.output,
                     "Output file: .ndjson, .felt, .svg, .pdf, .png; '-' is stdout");
  command.add_option("--to", args.to, "Output format; the default is set by the file extension");
  command.add_option(
      "--on", args.on,
      "A drawing to start from, with its surface: .felt, .ndjson, or .svg by Feltline");
  command.add_option(
      "--forces", args.forces,
      "Save pose, requested force, sent force and each force term, a row per tick, as .csv");
  command.add_option("--plot", args.plot, "Plot the same over time as a .png");
  command.add_option("--sound", args.sound, "Save the sound of the pen on the surface as a .wav");
  command.add_option("--stats", args.stats, "Print counts, forces and accuracy on stdout")
      ->check(CLI::IsMember({"json"}));
}

void add_options(CLI::App& command, ReplayCommandArguments& args) {
  add_output_options(command, args);
  args.pen.add_pen_to(command);
  args.pen.add_loop_to(command);
  command
      .add_option("--seed", args.seed, "Seed of the hand's tremor for raw strokes; 0 for no tremor")
      ->check(whole_number())
      ->capture_default_str();
  command.add_option("--sheet,--material", args.page_surface)->group("");  // former names
  command.add_option("--medium", args.medium,
                     "The medium to draw with, in its default widths and colour: an id of\n"
                     "'feltline materials'");
  command.add_option("--set", args.options, "Set TOOL.OPTION=VALUE before the first event")
      ->allow_extra_args(false);
  command
      .add_option("--until", args.until_ms,
                  "Stop at this time, in ms, and include the unfinished gesture")
      ->check(number_between(0.0, limits::kMaxEventTimeMs));
  command.add_flag("--overlay", args.overlay, "Also show the tool's overlay in the .png");
  command.add_flag(
      "--as-recorded", args.as_recorded,
      "The script is a recording: draw its samples unchanged, without device, hand and forces");
  command.add_flag("--recording", args.recording,
                   "Save in the .felt how it was drawn: samples, forces, events");
  command.add_option("--mm-per-unit", args.mm_per_unit, "Size of one unit of raw strokes, in mm")
      ->check(number_between(1e-9, 1e9))
      ->capture_default_str();
  args.picture.add_to(command);
  args.picture.add_grain_to(command);
}

/// The outputs of a replay. Each is optional.
struct ReplayOutputs {
  std::optional<DrawingOutput> drawing;
  std::optional<Output> view;  ///< used instead of `drawing` to show the overlay
  PictureOptions picture;
  std::optional<SessionView> stopped;        ///< state when the replay was stopped
  std::optional<Document> stopped_document;  ///< document when the replay was stopped
  std::optional<ForcesFile> forces;
  std::optional<ForcePlot> plot;
  std::unique_ptr<ReplaySound> sound;  ///< on the heap because it is large
  std::optional<FeltRecorder> recorder;
  const ScriptRun* run = nullptr;  ///< set while the replay runs, to show its progress
};

void check_recording(const ReplayCommandArguments& args) {
  if (args.output.empty()) throw UsageError("--recording needs -o OUT.felt");
  if (!args.on.empty() || args.until_ms) {
    throw UsageError("--recording saves a whole drawing, so it cannot be used with " +
                     std::string(args.until_ms ? "--until" : "--on"));
  }
}

/// Throws a usage error if a file is both read and written, or is written twice.
void check_files(const ReplayCommandArguments& args, Console& console) {
  std::vector<std::string> inputs = args.scripts;
  if (!args.on.empty()) inputs.push_back(args.on);
  check_no_overwrite(inputs,
                     {{"-o", args.output},
                      {"--forces", args.forces},
                      {"--plot", args.plot},
                      {"--sound", args.sound}},
                     console);
}

void check_outputs(const ReplayCommandArguments& args) {
  if (args.overlay && args.output.empty()) throw UsageError("--overlay needs -o OUT.png");
  if (args.output.empty() && args.forces.empty() && args.plot.empty() && args.sound.empty() &&
      args.stats.empty()) {
    throw UsageError("replay needs -o OUT, --forces, --plot, --sound or --stats");
  }
  if (args.recording) check_recording(args);
  const int to_stdout = (args.output == "-") + (args.forces == "-") + (args.plot == "-") +
                        (args.sound == "-") + !args.stats.empty();
  if (to_stdout > 1) {
    throw UsageError("only one of -o, --forces, --plot, --sound and --stats can use stdout");
  }
}

/// Returns the id of the surface to draw on, or "". A .png is only the relief of the picture.
std::string drawn_surface(const ReplayCommandArguments& args) {
  if (!args.page_surface.empty()) return args.page_surface;
  return args.picture.surface.ends_with(".png") ? std::string() : args.picture.surface;
}

/// If --surface names a .toml file that is drawn on, adds the surface in that file to `known`.
void load_surface(ReplayCommandArguments& args, Materials& known) {
  if (!args.page_surface.empty() || !args.picture.surface.ends_with(".toml")) return;
  Result<SurfaceMaterial> surface = find_surface(args.picture.surface, known);
  if (!surface) throw UsageError({surface.error().code, "--surface: " + surface.error().message});
  args.page_surface = surface->id;
  known.put(*std::move(surface));
}

/// Returns the options of pictures. The page has the colour of the selected surface, unless the
/// user specified another colour.
PictureOptions picture_of(const ReplayCommandArguments& args, const Materials& known,
                          Console& console) {
  Result<PictureOptions> picture = args.picture.parse(console);
  if (!picture) throw UsageError(picture.error());
  const SurfaceMaterial* surface = known.find_surface(drawn_surface(args));
  if (surface && !picture->paper) picture->paper = usual_color(surface->color_rgb);
  return *std::move(picture);
}

/// Opens the output of the option -o.
Result<void> open_drawing(const ReplayCommandArguments& args, const ReplaySettings& settings,
                          Console& console, ReplayOutputs& outputs) {
  const Result<Format> format = output_format(args.output, args.to);
  if (!format) throw UsageError(format.error().message);
  outputs.picture = picture_of(args, settings.materials, console);
  const bool is_felt = *format == Format::kFelt;
  if (args.overlay && *format != Format::kPng) throw UsageError("--overlay needs -o OUT.png");
  if (args.recording && !is_felt) throw UsageError("--recording needs -o OUT.felt");
  if (args.overlay) {
    Result<Output> opened = Output::create(args.output);
    if (!opened) return tl::unexpected(opened.error());
    outputs.view.emplace(*std::move(opened));
    return {};
  }
  Result<DrawingOutput> opened = DrawingOutput::create(args.output, *format, outputs.picture);
  if (!opened) return tl::unexpected(opened.error());
  outputs.drawing.emplace(*std::move(opened));
  if (!args.recording) return {};
  const Capabilities& device = settings.device.capabilities;
  outputs.recorder.emplace("simulated " + args.pen.device, device.period_ns);
  outputs.recorder->event({0, UseDevice{device}});
  return {};
}

Result<ReplayOutputs> open_outputs(const ReplayCommandArguments& args,
                                   const ReplaySettings& settings, Console& console) {
  ReplayOutputs outputs;
  if (!args.output.empty()) {
    if (Result<void> opened = open_drawing(args, settings, console, outputs); !opened) {
      return tl::unexpected(opened.error());
    }
  }
  if (!args.forces.empty()) {
    Result<ForcesFile> opened = ForcesFile::create(args.forces);
    if (!opened) return tl::unexpected(opened.error());
    outputs.forces.emplace(*std::move(opened));
  }
  if (!args.sound.empty()) {
    Result<ReplaySound> opened = ReplaySound::create(args.sound);
    if (!opened) return tl::unexpected(opened.error());
    outputs.sound = std::make_unique<ReplaySound>(*std::move(opened));
  }
  if (!args.plot.empty()) {
    const Capabilities& device = settings.device.capabilities;
    outputs.plot.emplace(1e-9 * static_cast<double>(device.period_ns), limits_for(device));
  }
  return outputs;
}

std::string text_of(const OptionValue& value) {
  const double* number = std::get_if<double>(&value);
  return number ? fmt::format("{}", *number) : std::get<std::string>(value);
}

/// Sets the options of the drawing that --on names, and then those of the command line.
void set_options(const ReplayCommandArguments& args, const Drawing& start, ReplayMachine& machine) {
  const auto set = [&machine](const char* from, const std::string& id, const std::string& value) {
    const Result<void> done = machine.set_option(id, value);
    if (!done) throw UsageError(std::string(from) + ": " + done.error().message);
  };
  const Materials& known = machine.session().materials();
  for (const auto& [id, value] : options_of(start, known)) set("--on", id, value);
  if (const std::string surface = drawn_surface(args); !surface.empty()) {
    set("--surface", "surface.material", surface);
  }
  if (!args.medium.empty()) {
    // If a medium of that name does not exist, this fails with a list of media.
    set("--medium", drawing_option(machine.session(), "medium"), args.medium);
    const Medium& medium = *known.find_medium(args.medium);
    for (const SetOption& option : options_for_medium(machine.session(), medium)) {
      set("--medium", option.id, text_of(option.value));
    }
    const std::uint32_t ink = ink_color_on(medium.color_rgb, machine.session().surface().color_rgb);
    set("--medium", "ink.color", color_to_text(usual_color(ink)));
  }
  for (const std::string& option : args.options) {
    const std::size_t equals = option.find('=');
    if (equals == std::string::npos) {
      throw UsageError("--set: '" + option + "' is not TOOL.OPTION=VALUE");
    }
    set("--set", option.substr(0, equals), option.substr(equals + 1));
  }
}

Result<void> play_scripts(const ReplayCommandArguments& args, ScriptRun& run, Console& console) {
  run.expect(args.scripts);
  for (const std::string& script : args.scripts) {
    const Result<void> read = read_script_file(script, run);
    report_notices(input_name(script), run.report(), console);
    if (!read) return read;
  }
  return run.play();
}

/// Writes the picture with the overlay.
Result<void> write_view(const SessionView& view, ReplayOutputs& outputs) {
  const Result<Image> image = draw_view(view, outputs.picture);
  if (!image) return tl::unexpected(image.error());
  const Result<std::string> bytes = encode_png(*image, outputs.picture.dpi);
  if (!bytes) return tl::unexpected(bytes.error());
  if (Result<void> written = outputs.view->write(*bytes); !written) return written;
  return outputs.view->commit();
}

/// Writes the whole drawing. With --recording, includes the recording.
Result<void> write_replayed(Drawing start, const Session& session, ReplayOutputs& outputs) {
  Document document = outputs.stopped_document ? *std::move(outputs.stopped_document)
                      : outputs.recorder       ? session.document()
                                               : seen_document(session);
  Drawing drawing = drawing_after(std::move(start), session, std::move(document));
  if (outputs.recorder) {
    Result<void> added = add_recording(drawing, outputs.recorder->take());
    if (!added) return added;
  }
  return outputs.drawing->write(std::move(drawing));
}

Result<void> write_outputs(const ReplayCommandArguments& args, Drawing start,
                           ReplayOutputs& outputs, ReplayMachine& machine) {
  if (outputs.plot) {
    outputs.plot->set_title(
        "Replay", fmt::format("simulated {}, {} hand, {:.0f} Hz", args.pen.device, args.pen.hand,
                              outputs.plot->rate_hz()));
    const Result<Image> picture = outputs.plot->draw();
    if (!picture) return tl::unexpected(picture.error());
    if (Result<void> done = write_png(args.plot, *picture, kPlotDpi); !done) return done;
  }
  if (outputs.forces) {
    if (Result<void> done = outputs.forces->finish(); !done) return done;
  }
  if (outputs.sound) {
    if (Result<void> done = outputs.sound->finish(); !done) return done;
  }
  if (outputs.drawing) return write_replayed(std::move(start), machine.session(), outputs);
  if (!outputs.view) return {};
  return write_view(
      outputs.stopped ? *std::move(outputs.stopped) : view_of(machine.session(), std::nullopt),
      outputs);
}

/// Passes a tick to the outputs.
Result<void> take_tick(ReplayOutputs& outputs, const ReplayTick& tick) {
  const TickReport& report = tick.report;
  if (outputs.recorder) {
    outputs.recorder->forces(report.sample.time_ns, report.asked, report.sent);
  }
  if (outputs.plot) outputs.plot->add(tick.report, tick.width_mm);
  if (outputs.forces) {
    if (Result<void> done = outputs.forces->add(report, tick.pressure); !done) return done;
  }
  return outputs.sound && report.sample_ok ? outputs.sound->add(report.sample) : Result<void>();
}

ReplayMachine::Observer observer_of(const ReplayCommandArguments& args, ReplayOutputs& outputs,
                                    Console& console) {
  ReplayMachine::Observer observer;
  if (args.until_ms) {
    observer.until_ns = std::llround(1e6 * *args.until_ms);
    observer.stopped = [&outputs](const Session& session, const PenSample& pen) {
      outputs.stopped = view_of(session, on_page(pen.position));
      outputs.stopped_document = seen_document(session);
    };
  }
  if (outputs.recorder) {
    observer.event = [&outputs](const Event& event) { outputs.recorder->event(event); };
  }
  if (outputs.plot || outputs.forces || outputs.sound || outputs.recorder) {
    observer.tick = [&outputs](const ReplayTick& tick) { return take_tick(outputs, tick); };
  }
  observer.turn = [&console, &outputs](const Session& session, double part) {
    const double done = outputs.run ? outputs.run->progress(part) : 0.0;
    console.progress("playing", static_cast<std::int64_t>(1e6 * done), 1'000'000,
                     static_cast<std::int64_t>(session.document().stroke_count()));
  };
  return observer;
}

/// Throws a usage error for options that need a device, a hand and a loop.
void check_as_recorded(const ReplayCommandArguments& args, const CLI::App& command) {
  for (const char* option :
       {"--forces", "--plot", "--stats", "--device", "--hand", "--rate", "--delay", "--limit",
        "--no-force", "--seed", "--surface", "--sheet", "--medium", "--set", "--until", "--overlay",
        "--mm-per-unit", "--recording"}) {
    if (command.count(option) == 0) continue;
    throw UsageError(std::string(option) +
                     " cannot be used with --as-recorded: a recording is drawn unchanged, without "
                     "device, hand and forces");
  }
  if (args.scripts.size() > 1) throw UsageError("--as-recorded plays one recording at a time");
  if (args.output.empty() && args.sound.empty()) {
    throw UsageError("--as-recorded needs -o OUT or --sound");
  }
  if (args.output == "-" && args.sound == "-") {
    throw UsageError("only one of -o and --sound can use stdout");
  }
}

/// Returns the drawing that --on names, or an empty drawing without that option.
Result<Drawing> start_of(const ReplayCommandArguments& args) {
  return args.on.empty() ? Drawing{.has_page = false} : read_start(args.on);
}

/// Sets the session's surface and ink colour to those of the drawing.
Result<void> take_up(const Drawing& start, Session& session) {
  for (const auto& [id, value] : options_of(start, session.materials())) {
    if (Result<void> done = session.apply({0, SetOption{id, value}}); !done) return done;
  }
  return {};
}

/// Plays the recording and writes the resulting drawing. `heard` is the result of writing the sound
/// file.
Result<void> draw_recorded(const ReplayCommandArguments& args, Drawing start,
                           const Result<void>& heard, Session& session, ReplayOutputs& outputs,
                           Console& console) {
  if (Result<void> begun = take_up(start, session); !begun) return begun;
  if (outputs.sound) outputs.sound->begin(session);
  Result<Drawing> frame = apply_recording_file(args.scripts.front(), session);
  if (!frame) return tl::unexpected(frame.error());
  note_refusals(input_name(args.scripts.front()), session.refusals(), console);
  if (session.option_defaults() != kOptionDefaults) {
    console.notice(input_name(args.scripts.front()) +
                   ": recorded by an earlier version of Feltline. Its option defaults were used, "
                   "but the tools have changed, so the drawing may differ");
  }
  if (!heard) return heard;
  if (args.on.empty()) start = *std::move(frame);
  if (outputs.sound) {
    if (Result<void> done = outputs.sound->finish(); !done) return done;
  }
  if (!outputs.drawing) return {};
  return outputs.drawing->write(drawing_after(std::move(start), session, session.document()));
}

void run_as_recorded(const ReplayCommandArguments& args, Console& console) {
  Result<Drawing> start = start_of(args);
  if (!start) return console.error(start.error().message);
  Result<ReplayOutputs> outputs = open_outputs(args, args.pen.settings(), console);
  if (!outputs) return console.error(outputs.error().message);
  Result<void> heard;
  SessionOptions options{
      .device = {},
      .materials = with_texts(start->materials, known_materials(console).materials),
      .document = start->document};
  if (outputs->sound) {
    options.on_event = [&](const Event& event) {
      const auto* pen = std::get_if<PenEvent>(&event.what);
      if (pen && heard) heard = outputs->sound->add(sample_of(event.time_ns, *pen));
    };
  }
  Session session(make_tools(), std::move(options));
  const Result<void> done =
      draw_recorded(args, *std::move(start), heard, session, *outputs, console);
  if (!done) console.error(done.error().message);
}

void run_replay(ReplayCommandArguments args, Console& console) {
  check_outputs(args);
  check_files(args, console);
  const auto begin = std::chrono::steady_clock::now();
  Result<Drawing> start = start_of(args);
  if (!start) return console.error(start.error().message);
  ReplaySettings settings = args.pen.settings();
  settings.read_import = reads_imports("", {args.output, args.forces, args.plot, args.sound});
  settings.materials = with_texts(start->materials, known_materials(console).materials);
  load_surface(args, settings.materials);
  if (!drawn_surface(args).empty()) start->page.surface.clear();  // another surface is selected
  Result<ReplayOutputs> outputs = open_outputs(args, settings, console);
  if (!outputs) return console.error(outputs.error().message);
  ReplayMachine machine(settings, start->document, observer_of(args, *outputs, console));
  if (outputs->sound) outputs->sound->begin(machine.session());
  set_options(args, *start, machine);
  ScriptRun run(machine, args.mm_per_unit, args.seed);
  outputs->run = &run;
  Result<void> done = play_scripts(args, run, console);
  console.end_progress();
  note_refusals(input_name(args.scripts.front()), machine.session().refusals(), console);
  if (done && console.failed()) return;  // a notice with --strict
  if (done) done = write_outputs(args, *std::move(start), *outputs, machine);
  if (!done) return console.error(done.error().message);
  if (args.stats.empty()) return;
  const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - begin;
  ReplayStats stats = machine.take_stats();
  stats.wall_s = wall.count();
  print("{}", stats_json(stats));
}

}  // namespace

void add_replay_command(CLI::App& app, Console& console) {
  CLI::App* command =
      app.add_subcommand("replay", "Play events or pen strokes through a simulated pen");
  const auto args = std::make_shared<ReplayCommandArguments>();
  add_options(*command, *args);
  command->footer(examples(kReplayExamples));
  command->callback([args, command, &console] {
    if (args->as_recorded) {
      check_as_recorded(*args, *command);
      check_files(*args, console);
      return run_as_recorded(*args, console);
    }
    run_replay(*args, console);
  });
}

}  // namespace felt::cli
