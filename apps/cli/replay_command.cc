#include <fmt/core.h>

#include <chrono>
#include <cmath>
#include <memory>

#include "commands.h"
#include "felt/formats/drawing_writer.h"
#include "felt/formats/own_materials.h"
#include "felt/io/limits.h"
#include "felt/io/png.h"
#include "felt/store/felt_recording.h"
#include "force_plot.h"
#include "forces_csv.h"
#include "overlay_picture.h"
#include "own_materials.h"
#include "picture.h"
#include "recording.h"
#include "replay_arguments.h"
#include "replay_run.h"
#include "replay_sound.h"
#include "sketch_output.h"

namespace felt::cli {
namespace {

constexpr double kPlotDpi = 192.0;  // two pixels a unit, 96 units an inch

/// The command line as written.
struct ReplayCommandArguments {
  std::vector<std::string> scripts;
  std::string output, to;
  std::string on;
  std::string forces, plot, sound, stats;
  ReplayArguments pen;
  std::uint64_t seed = 0;
  std::string sheet, medium;
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
    "feltline replay strokes.ndjson --sheet canvas --medium chalk --sound rubbing.wav\n"
    "feltline replay strokes.ndjson --recording -o sketch.felt\n"
    "feltline replay strokes.ndjson --device premium --hand light --set pencil.snap=off \\\n"
    "      --stats json";

void add_output_options(CLI::App& command, ReplayCommandArguments& args) {
  command
      .add_option("EVENTS", args.scripts,
                  "Event scripts, raw pen strokes, or both in one, .ndjson; '-' is stdin")
      ->required();
  command.add_option("-o,--output", args.output,
                     "Where the sketch goes: .ndjson, .felt, .svg, .pdf, .png; '-' is stdout");
  command.add_option("--to", args.to, "Format of the output, instead of by its extension");
  command.add_option("--on", args.on, "A drawing to begin with: .felt, .ndjson, .svg of Feltline");
  command.add_option("--forces", args.forces,
                     "Pose, force asked, force sent and each force term, a row a tick, .csv");
  command.add_option("--plot", args.plot, "The same over time as a picture, .png");
  command.add_option("--sound", args.sound, "What the pen sounds like on the sheet, .wav");
  command
      .add_option("--stats", args.stats, "Print counts, forces and how close the ink is, on stdout")
      ->check(CLI::IsMember({"json"}));
}

void add_options(CLI::App& command, ReplayCommandArguments& args) {
  add_output_options(command, args);
  args.pen.add_pen_to(command);
  args.pen.add_loop_to(command);
  command.add_option("--seed", args.seed, "Number of a tremor for raw strokes; 0 = none")
      ->capture_default_str();
  command.add_option("--sheet,--material", args.sheet,
                     "What is drawn on:\n" + surface_names() + ", or one of your own");
  command.add_option("--medium", args.medium,
                     "What is drawn with, in its own widths: an id of 'feltline materials'");
  command.add_option("--set", args.options, "TOOL.OPTION=VALUE before the first event")
      ->allow_extra_args(false);
  command
      .add_option("--until", args.until_ms,
                  "Stop at this time, in ms, and show what is in work then as it is")
      ->check(number_between(0.0, limits::kMaxEventTimeMs));
  command.add_flag("--overlay", args.overlay,
                   "Show in the .png what the tool shows besides the ink, too");
  command.add_flag("--as-recorded", args.as_recorded,
                   "The script is a recording: its samples are drawn as they are, without device, "
                   "hand and forces");
  command.add_flag("--recording", args.recording,
                   "Keep in the .felt how it was drawn: samples, forces, events");
  command.add_option("--mm-per-unit", args.mm_per_unit, "Size of one unit of raw strokes, in mm")
      ->check(number_between(1e-9, 1e9))
      ->capture_default_str();
  args.picture.add_to(command);
}

/// What a replay writes; each may be absent.
struct ReplayOutputs {
  std::optional<Format> format;
  std::unique_ptr<SketchOutput> sketch;
  std::optional<Output> view;  ///< instead of `sketch` where the overlay is to be seen
  PictureOptions picture;
  std::optional<SessionView> stopped;  ///< what was in work when the play was stopped
  std::optional<ForcesCsv> forces;
  std::optional<ForcePlot> plot;
  std::unique_ptr<ReplaySound> sound;  ///< large
  std::optional<FeltRecorder> recorder;
  const ReplayRun* run = nullptr;  ///< while it plays: how far it is
};

void check_recording(const ReplayCommandArguments& args) {
  if (args.output.empty()) throw UsageError("--recording needs -o OUT.felt");
  if (!args.on.empty()) {
    throw UsageError("--recording tells a drawing from its beginning: it does not go with --on");
  }
  if (args.until_ms) {
    throw UsageError("--recording tells all of a script: it does not go with --until");
  }
}

void check_outputs(const ReplayCommandArguments& args) {
  if (args.overlay && args.output.empty()) throw UsageError("--overlay needs -o OUT.png");
  if (args.output.empty() && args.forces.empty() && args.plot.empty() && args.sound.empty() &&
      args.stats.empty()) {
    throw UsageError("replay needs -o OUT, --forces, --plot, --sound or --stats");
  }
  if (args.recording) check_recording(args);
  const int to_stdout = (args.output == "-" ? 1 : 0) + (args.forces == "-" ? 1 : 0) +
                        (args.plot == "-" ? 1 : 0) + (args.sound == "-" ? 1 : 0) +
                        (args.stats.empty() ? 0 : 1);
  if (to_stdout > 1) {
    throw UsageError("-o, --forces, --plot, --sound and --stats: only one can have stdout");
  }
}

Result<void> open_sketch(const ReplayCommandArguments& args, const ReplaySettings& settings,
                         ReplayOutputs& outputs) {
  if (args.recording) {
    const Capabilities& device = settings.device.capabilities;
    outputs.recorder.emplace("simulated " + args.pen.device, device.period_ns);
    outputs.recorder->event({0, UseDevice{device}});
    return {};
  }
  if (args.overlay) {
    Result<Output> opened = Output::create(args.output);
    if (!opened) return tl::unexpected(opened.error());
    outputs.view.emplace(*std::move(opened));
    return {};
  }
  Result<std::unique_ptr<SketchOutput>> opened =
      open_sketch_output(args.output, *outputs.format, outputs.picture);
  if (!opened) return tl::unexpected(opened.error());
  outputs.sketch = *std::move(opened);
  return {};
}

/// What -o names.
Result<void> open_drawing(const ReplayCommandArguments& args, const ReplaySettings& settings,
                          ReplayOutputs& outputs) {
  const Result<Format> format = output_format(args.output, args.to);
  if (!format) throw UsageError(format.error().message);
  const Result<PictureOptions> picture = args.picture.parse();
  if (!picture) throw UsageError(picture.error().message);
  if (args.overlay && *format != Format::kPng) throw UsageError("--overlay needs -o OUT.png");
  if (args.recording && *format != Format::kFelt) {
    throw UsageError("--recording needs -o OUT.felt");
  }
  outputs.format = *format;
  outputs.picture = *picture;
  return open_sketch(args, settings, outputs);
}

Result<ReplayOutputs> open_outputs(const ReplayCommandArguments& args,
                                   const ReplaySettings& settings) {
  ReplayOutputs outputs;
  if (!args.output.empty()) {
    if (Result<void> opened = open_drawing(args, settings, outputs); !opened) {
      return tl::unexpected(opened.error());
    }
  }
  if (!args.forces.empty()) {
    Result<ForcesCsv> opened = ForcesCsv::create(args.forces);
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

void set_options(const ReplayCommandArguments& args, ReplayMachine& machine) {
  const auto set = [&machine](const char* from, const std::string& id, const std::string& value) {
    const Result<void> done = machine.set_option(id, value);
    if (!done) throw UsageError(std::string(from) + ": " + done.error().message);
  };
  if (!args.sheet.empty()) set("--sheet", "sheet.material", args.sheet);
  if (!args.medium.empty()) {
    set("--medium", "pencil.material", args.medium);
    const MediumLine line = machine.session().materials().find_medium(args.medium)->line;
    set("--medium", "pencil.min_width_mm", fmt::format("{}", line.min_mm));
    set("--medium", "pencil.max_width_mm", fmt::format("{}", line.max_mm));
    set("--medium", "pencil.gamma", fmt::format("{}", line.gamma));
  }
  for (const std::string& option : args.options) {
    const std::size_t equals = option.find('=');
    if (equals == std::string::npos) {
      throw UsageError("--set: '" + option + "' is not TOOL.OPTION=VALUE");
    }
    set("--set", option.substr(0, equals), option.substr(equals + 1));
  }
}

Result<void> play_scripts(const ReplayCommandArguments& args, ReplayRun& run) {
  run.expect(args.scripts);
  for (const std::string& script : args.scripts) {
    if (Result<void> taken = run.file(script); !taken) return taken;
  }
  return run.play();
}

/// The picture with overlay.
Result<void> write_view(const SessionView& view, ReplayOutputs& outputs) {
  const Result<Image> image = draw_view(view, outputs.picture);
  if (!image) return tl::unexpected(image.error());
  const Result<std::string> bytes = encode_png(*image, outputs.picture.dpi);
  if (!bytes) return tl::unexpected(bytes.error());
  if (Result<void> written = outputs.view->write(*bytes); !written) return written;
  return outputs.view->commit();
}

/// The whole drawing, and how it was made.
Result<void> write_recorded(const ReplayCommandArguments& args, FeltRecorder& recorder,
                            const Session& session) {
  StoredDrawing drawing;
  drawing.document = session.document();
  drawing.page.surface = session.sheet().material().id;
  drawing.materials = texts_of_used(session.document(), drawing.page.surface, session.materials());
  drawing.color = session.sheet().color();
  drawing.layer = session.layer();
  if (Result<void> added = add_recording(drawing, recorder.take()); !added) return added;
  return write_drawing(args.output, drawing, FileFormat::kFelt);
}

Result<void> write_outputs(const ReplayCommandArguments& args, ReplayOutputs& outputs,
                           ReplayMachine& machine) {
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
  if (!outputs.format) return {};
  if (outputs.recorder) return write_recorded(args, *outputs.recorder, machine.session());
  const SessionView view =
      outputs.stopped ? *std::move(outputs.stopped) : view_of(machine.session(), std::nullopt);
  if (outputs.view) return write_view(view, outputs);
  return write_strokes(view.sketch, *outputs.format, *outputs.sketch);
}

/// What a tick leaves in the outputs.
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
      outputs.stopped = view_of(session, on_sheet(pen.position));
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

/// What has no meaning where there is no device, hand and loop.
void check_as_recorded(const ReplayCommandArguments& args, const CLI::App& command) {
  for (const char* option : {"--forces", "--plot", "--stats", "--device", "--hand", "--rate",
                             "--delay", "--no-force", "--seed", "--sheet", "--medium", "--set",
                             "--until", "--overlay", "--mm-per-unit", "--recording"}) {
    if (command.count(option) == 0) continue;
    throw UsageError(std::string(option) +
                     " does not go with --as-recorded: a recording is drawn as it is, without "
                     "device, hand and forces");
  }
  if (args.scripts.size() > 1) throw UsageError("--as-recorded plays one recording at a time");
  if (args.output.empty() && args.sound.empty()) {
    throw UsageError("--as-recorded needs -o OUT or --sound");
  }
  if (args.output == "-" && args.sound == "-") {
    throw UsageError("-o and --sound: only one can have stdout");
  }
}

/// Where the pen is, as a recording says it.
PenSample sample_of(std::int64_t time_ns, const PenEvent& pen) {
  PenSample sample;
  sample.time_ns = time_ns;
  sample.position = pen.position;
  sample.pressure = pen.pressure;
  return sample;
}

void run_as_recorded(const ReplayCommandArguments& args, Console& console) {
  Result<Document> start = args.on.empty() ? Document() : read_document(args.on);
  if (!start) return console.error(start.error().message);
  Result<ReplayOutputs> outputs = open_outputs(args, args.pen.settings());
  if (!outputs) return console.error(outputs.error().message);
  Result<void> heard;
  SessionOptions options{.device = {}, .document = *std::move(start)};
  if (outputs->sound) {
    options.on_event = [&](const Event& event) {
      const auto* pen = std::get_if<PenEvent>(&event.what);
      if (pen && heard) heard = outputs->sound->add(sample_of(event.time_ns, *pen));
    };
  }
  Session session(make_tools(), std::move(options));
  if (outputs->sound) outputs->sound->begin(session);
  Result<void> done = tell_recording(args.scripts.front(), session);
  if (done) done = heard;
  if (done && outputs->sound) done = outputs->sound->finish();
  if (done && outputs->sketch) {
    done = write_strokes(session.sketch(), *outputs->format, *outputs->sketch);
  }
  if (!done) console.error(done.error().message);
}

void run_replay(const ReplayCommandArguments& args, Console& console) {
  check_outputs(args);
  const auto start = std::chrono::steady_clock::now();
  ReplaySettings settings = args.pen.settings();
  settings.materials = known_materials(console).materials;
  Document document;
  if (!args.on.empty()) {
    Result<Document> drawing = read_document(args.on);
    if (!drawing) return console.error(drawing.error().message);
    document = *std::move(drawing);
  }
  Result<ReplayOutputs> outputs = open_outputs(args, settings);
  if (!outputs) return console.error(outputs.error().message);
  ReplayMachine machine(settings, std::move(document), observer_of(args, *outputs, console));
  if (outputs->sound) outputs->sound->begin(machine.session());
  set_options(args, machine);
  ReplayRun run(machine, args.mm_per_unit, args.seed);
  outputs->run = &run;
  Result<void> done = play_scripts(args, run);
  console.end_progress();
  if (done) done = write_outputs(args, *outputs, machine);
  if (!done) return console.error(done.error().message);
  const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - start;
  if (args.stats.empty()) return;
  ReplayStats stats = machine.take_stats();
  stats.wall_s = wall.count();
  fmt::print("{}", stats_json(stats));
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
      return run_as_recorded(*args, console);
    }
    run_replay(*args, console);
  });
}

}  // namespace felt::cli
