#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "act_pictures.h"
#include "commands.h"
#include "demo_ending.h"
#include "demo_scripts.h"
#include "drawing_output.h"
#include "felt/document/visible_strokes.h"
#include "felt/io/picture/png.h"
#include "felt/render/page_painter.h"
#include "felt/replay/replay_drawing.h"
#include "felt/replay/script_run.h"
#include "force_plot.h"
#include "forces_file.h"
#include "print.h"
#include "replay_arguments.h"
#include "text_table.h"

namespace felt::cli {
namespace {

constexpr double kDemoMarginMm = 6.0;
constexpr Rgba kDemoPaper{255, 254, 250, 255};
constexpr double kActDpi = 192.0;
constexpr double kPlotUnits = 900.0;
/// Time in seconds by which the plot begins before the pen first touches the surface.
constexpr double kPlotBeforeS = 0.25;
constexpr double kPlotS = 5.0;

constexpr const char* kLegend =
    "touches: how often the pen touched down. strokes: in the drawing, before and after. changed: "
    "strokes that were changed, added or removed. N: force sent while the pen is on the surface. "
    "off: mean distance between the path that the hand intended and the ink. real time: how many "
    "times faster than real time it was played.";

struct DemoArguments {
  std::string folder;
  int size_px = 1600;
  ReplayArguments pen;
};

/// The outputs that are written while the acts are played.
struct DemoRecorder {
  ForcesFile forces;
  ForcePlot plot;
  std::optional<double> first_contact_s{};
  PenSample pen{};
  ActPictures* act = nullptr;  ///< the current act

  Result<void> see(const ReplayTick& tick) {
    pen = tick.report.sample;
    if (!first_contact_s && in_contact(pen)) {
      first_contact_s = 1e-9 * static_cast<double>(pen.time_ns);
    }
    plot.add(tick.report, tick.width_mm);
    return forces.add(tick.report, tick.pressure);
  }
  void see(const Session& session) const {
    if (act) act->see(session, pen);
  }
};

/// The table of results, with one row for each act.
class Summary {
 public:
  void add(std::string_view act, const ReplayStats& stats) {
    const bool drew = stats.strokes_meant > 0;
    table_.add_row({std::string(act.substr(act.find('-') + 1)), std::to_string(stats.touches),
                    fmt::format("{} > {}", strokes_, stats.strokes),
                    std::to_string(stats.strokes_changed), std::to_string(stats.segments),
                    fmt::format("{:.2f}", stats.mean_sent_n()),
                    fmt::format("{:.2f}", stats.max_sent_n),
                    drew ? fmt::format("{:.3f}", stats.distance.mean_mm()) : "",
                    fmt::format("{:.1f}", stats.simulated_s),
                    fmt::format("{:.0f} x", stats.times_real_time())});
    strokes_ = stats.strokes;
    faults_ += stats.soft_faults + stats.hard_faults;
  }
  void print() const {
    const TextStyle style = TextStyle::of_stdout();
    cli::print("{}\n{}\n", table_.text(style), wrapped(kLegend, style.width, 0));
    if (faults_ > 0) cli::print("The safety chain intervened {} times.\n", faults_);
  }

 private:
  static constexpr TextTable::Align kRight = TextTable::Align::kRight;
  TextTable table_{{{"act"},
                    {"touches", kRight},
                    {"strokes", kRight},
                    {"changed", kRight},
                    {"segments", kRight},
                    {"mean N", kRight},
                    {"peak N", kRight},
                    {"off mm", kRight},
                    {"seconds", kRight},
                    {"real time", kRight}}};
  std::int64_t strokes_ = 0;
  std::int64_t faults_ = 0;
};

std::string path_in(const DemoArguments& args, const char* name) {
  return (std::filesystem::path(args.folder) / name).string();
}

Result<void> make_folder(const std::string& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) return fail(ErrorCode::kIo, folder + ": " + error.message());
  if (std::filesystem::is_directory(folder, error)) return {};
  return fail(ErrorCode::kIo, folder + ": not a folder");
}

Result<void> write_picture(const std::string& path, const Drawing& drawing,
                           const PictureOptions& picture) {
  const Result<Format> format = format_of_path(path);
  if (!format) return tl::unexpected(format.error());
  return DrawingOutput::create(path, *format, picture).and_then([&](DrawingOutput output) {
    return output.write(drawing);
  });
}

Drawing drawing_of(const Session& session) {
  return drawing_after({.has_page = false}, session, session.document());
}

Result<void> write_pictures(const DemoArguments& args, const Drawing& drawing) {
  PictureOptions picture;
  picture.area = ink_bounds(drawing.document).inflated(kDemoMarginMm);
  picture.dpi = kMmPerInch * args.size_px / picture.area->width();
  for (const char* name : {"sketch.ndjson", "sketch.svg"}) {
    if (auto done = write_picture(path_in(args, name), drawing, picture); !done) return done;
  }
  picture.paper = kDemoPaper;
  return write_picture(path_in(args, "sketch.png"), drawing, picture);
}

Result<void> write_plot(const DemoArguments& args, DemoRecorder& recorder) {
  ForcePlot& plot = recorder.plot;
  const PlotSpan whole = plot.whole();
  const double start_s =
      std::max(whole.start_s, recorder.first_contact_s.value_or(0.0) - kPlotBeforeS);
  plot.set_span({start_s, std::min(start_s + kPlotS, whole.end_s)});
  plot.set_title("What the hand feels",
                 fmt::format("simulated {}, {} hand, pencil on paper, {:.0f} Hz", args.pen.device,
                             args.pen.hand, plot.rate_hz()));
  const double scale = args.size_px / kPlotUnits;
  const Result<Image> image = plot.draw({.width = kPlotUnits, .scale = scale});
  if (!image) return tl::unexpected(image.error());
  return write_png(path_in(args, "forces.png"), *image, 96.0 * scale);
}

Result<void> play_act(const DemoScript& act, const DemoArguments& args, DemoRecorder& recorder,
                      ReplayMachine& machine, ScriptRun& run) {
  ActPictures pictures(act.name);
  recorder.act = &pictures;
  const std::string name = "act " + std::string(act.name);
  Result<void> done = run.script(name, "", read_text(act.text));
  if (done) done = run.play();
  recorder.act = nullptr;
  if (!done) return done;
  const Result<Image> image = pictures.draw(machine.session(), args.size_px);
  if (!image) return tl::unexpected(image.error());
  return write_png(path_in(args, (std::string(act.name) + ".png").c_str()), *image, kActDpi);
}

/// Plays all acts and writes their files. Returns the names of the files of the ending.
Result<std::vector<std::string>> play_acts(const DemoArguments& args, Console& console,
                                           DemoRecorder& recorder) {
  ReplayMachine::Observer observer;
  observer.tick = [&recorder](const ReplayTick& tick) { return recorder.see(tick); };
  observer.turn = [&](const Session& session, double fraction) {
    recorder.see(session);
    console.progress("drawing", static_cast<std::int64_t>(1e6 * fraction), 1'000'000,
                     static_cast<std::int64_t>(session.document().stroke_count()));
  };
  ReplayMachine machine(args.pen.settings(), Document(), observer);
  ScriptRun run(machine, 1.0, 0);
  Summary summary;
  std::optional<Drawing> first;  // after the first act, before anything is changed
  for (const DemoScript& act : demo_scripts()) {
    const auto start = std::chrono::steady_clock::now();
    Result<void> played = play_act(act, args, recorder, machine, run);
    if (!played) return tl::unexpected(played.error());
    if (!first) first = drawing_of(machine.session());
    ReplayStats stats = machine.take_stats();
    stats.wall_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    summary.add(act.name, stats);
  }
  console.end_progress();
  Result<void> done = write_pictures(args, drawing_of(machine.session()))
                          .and_then([&] { return write_plot(args, recorder); })
                          .and_then([&] { return recorder.forces.finish(); });
  if (!done) return tl::unexpected(done.error());
  console.status("making the solid and the fish");
  auto ending = write_demo_ending(*first, args.folder, args.size_px);
  console.end_progress();
  if (ending) summary.print();
  return ending;
}

void run_demo(const DemoArguments& args, Console& console) {
  if (Result<void> made = make_folder(args.folder); !made)
    return console.error(made.error().message);
  Result<ForcesFile> forces = ForcesFile::create(path_in(args, "forces.csv"));
  if (!forces) return console.error(forces.error().message);
  const Capabilities device = args.pen.settings().device.capabilities;
  DemoRecorder recorder{*std::move(forces), ForcePlot(1e-9 * static_cast<double>(device.period_ns),
                                                      limits_for(device))};
  const Result<std::vector<std::string>> played = play_acts(args, console, recorder);
  console.end_progress();
  if (!played) return console.error(played.error().message);
  print("\nIn {}: sketch.svg, sketch.png, sketch.ndjson, forces.csv, forces.png", args.folder);
  for (const DemoScript& act : demo_scripts()) print(", {}.png", act.name);
  for (const std::string& name : *played) print(", {}", name);
  print("\n");
}

}  // namespace

void add_demo_command(CLI::App& app, Console& console) {
  CLI::App* command = app.add_subcommand("demo", "Let the simulated hand draw and edit a picture");
  const auto args = std::make_shared<DemoArguments>();
  command
      ->add_option("-o,--output", args->folder,
                   "The folder for pictures and forces; created if it does not exist")
      ->required();
  command->add_option("--size", args->size_px, "Width of the pictures in pixels")
      ->check(CLI::Range(200, 20000))
      ->capture_default_str();
  args->pen.add_pen_to(*command);
  command->footer(
      examples("feltline demo -o demo\n"
               "feltline demo -o demo --hand light --device premium --size 3000"));
  command->callback([args, &console] { run_demo(*args, console); });
}

}  // namespace felt::cli
