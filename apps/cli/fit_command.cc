#include <fmt/core.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <thread>

#include "commands.h"
#include "felt/formats/format_traits.h"
#include "felt/io/import.h"
#include "felt/material/materials.h"
#include "felt/tools/medium_line.h"
#include "fit_source.h"
#include "fit_worker.h"
#include "ordered_pipeline.h"
#include "overwrite_check.h"
#include "print.h"
#include "steady_file.h"

namespace felt::cli {
namespace {

/// The options and arguments of the command line.
struct FitArguments {
  std::vector<std::string> inputs;
  std::string output;
  std::string to;
  double tolerance_mm = CurveFitOptions{}.tolerance_mm;
  double mm_per_unit = 1.0;
  bool no_refine = false;
  std::string steady;
  bool filter = false;
  std::string scheme = "feltline";
  int shared_samples = InkFitOptions{}.shared_samples;
  std::string stats;
  int jobs = 1;
  std::string medium;
  std::optional<double> min_width_mm, max_width_mm;
  PictureArguments picture;
};

constexpr const char* kFitExamples =
    "feltline fit strokes.ndjson -o sketch.svg\n"
    "feltline fit scan.ndjson --mm-per-unit 0.01 --tolerance 0.1 -o sketch.ndjson\n"
    "feltline fit strokes.ndjson --medium charcoal -o sketch.png\n"
    "feltline fit strokes.ndjson --stats json\n"
    "feltline fit strokes.ndjson --steady my-hand.steady -o sketch.svg\n"
    "cat strokes.ndjson | feltline fit - -o - | feltline render - -o page.png";

std::string media_names() {
  std::string names;
  for (const Medium& medium : Materials::built_in().media()) {
    if (medium.draws) names += (names.empty() ? "" : ", ") + medium.id;
  }
  return names;
}

/// Returns the error message if the id is not that of a known medium, or an empty string if it is.
std::string check_medium(const std::string& id) {
  const Medium* medium = find_medium(id);
  if (medium && medium->draws) return {};
  return fmt::format("unknown medium '{}'; the media are {}", id, media_names());
}

void add_width_options(CLI::App& command, FitArguments& args) {
  command
      .add_option("--medium,--material", args.medium,
                  "Medium of the lines; it sets widths, tone and response to tilt [ink-pen, with "
                  "other widths]: " +
                      media_names())
      ->check(CLI::Validator(check_medium, "ID"));
  command
      .add_option(
          "--min-width", args.min_width_mm,
          fmt::format("Width in mm without pressure [{}, or the medium's]", kPenWidths.min_mm))
      ->check(number_between(kMinWidthMm, 1000.0));
  command
      .add_option(
          "--max-width", args.max_width_mm,
          fmt::format("Width in mm at full pressure [{}, or the medium's]", kPenWidths.max_mm))
      ->check(number_between(kMinWidthMm, 1000.0));
}

/// Returns the settings for the medium and its widths from the command line.
InkFitOptions ink_of(const FitArguments& args) {
  InkFitOptions ink;
  const Medium* medium = args.medium.empty() ? nullptr : find_medium(args.medium);
  WidthMapOptions& widths = ink.width_map;
  if (medium) {
    widths.min_mm = medium->line.min_mm;
    widths.max_mm = medium->line.max_mm;
    widths.gamma = medium->line.gamma;
  }
  widths.min_mm = args.min_width_mm.value_or(widths.min_mm);
  widths.max_mm = args.max_width_mm.value_or(widths.max_mm);
  if (widths.max_mm < widths.min_mm) {
    throw UsageError(fmt::format("--max-width ({}) is less than --min-width ({})", widths.max_mm,
                                 widths.min_mm));
  }
  ink.width.max_mm = std::max(ink.width.max_mm, widths.max_mm);
  return medium ? drawn_with(*medium, std::move(ink)) : solid_fit(std::move(ink));
}

void add_options(CLI::App& command, FitArguments& args) {
  command
      .add_option("IN", args.inputs,
                  "Raw pen strokes: .ndjson (Quick, Draw! too), .inkml, .xopp; '-' is stdin")
      ->required();
  command.add_option("-o,--output", args.output,
                     "Output file ('-' is stdout). Formats: " + writable_names());
  command.add_option("--to", args.to, "Output format; the default is set by the file extension");
  command
      .add_option("--tolerance", args.tolerance_mm,
                  "Largest distance from a sample to the curve, in mm")
      ->check(number_between(0.0, 1e9))
      ->capture_default_str();
  command.add_option("--mm-per-unit", args.mm_per_unit, "Size of one unit of raw .ndjson, in mm")
      ->check(number_between(1e-9, 1e9))
      ->capture_default_str();
  command.add_flag("--no-refine", args.no_refine, "Keep the curve that was shown while drawing");
  command.add_flag("--filter", args.filter,
                   "Drop what the pen adds at touch-down and lift (late pressure, hooks)");
  command.add_option("--steady", args.steady,
                     "Remove the shaking of a hand: a file of 'feltline steady calibrate', or "
                     "HZ,MM,DEG (frequency, amplitude, axis)");
  command.add_option("--scheme", args.scheme, "Fitting scheme: feltline, or paper2002 for study")
      ->check(CLI::IsMember({"feltline", "paper2002"}))
      ->capture_default_str();
  command
      .add_option("--shared-samples", args.shared_samples,
                  "Samples that neighbouring segments share (s of the paper; paper2002 only)")
      ->check(CLI::Range(0, 1000))
      ->capture_default_str();
  command.add_option("--stats", args.stats, "Print timing and accuracy on stdout")
      ->check(CLI::IsMember({"json"}));
  command
      .add_option("-j,--jobs", args.jobs,
                  "Number of threads; 0 uses all cores. Does not affect the output")
      ->check(CLI::Range(0, 1024))
      ->capture_default_str();
  add_width_options(command, args);
  args.picture.add_to(command);
}

/// The parsed settings of the command line.
struct FitPlan {
  FitSettings settings;
  std::optional<Format> format;  // of the output
  PictureOptions picture;
  int jobs = 1;
};

FitPlan plan_of(const FitArguments& args, Console& console) {
  if (args.output.empty() && args.stats.empty()) throw UsageError("fit needs -o OUT or --stats");
  if (args.output == "-" && !args.stats.empty()) {
    throw UsageError("-o - and --stats cannot both use stdout");
  }
  check_no_overwrite(args.inputs, {{"-o", args.output}}, console);
  FitPlan plan;
  plan.settings.ink = ink_of(args);
  plan.settings.ink.scheme =
      args.scheme == "paper2002" ? FitScheme::kPaper2002 : FitScheme::kFeltline;
  plan.settings.ink.curve.tolerance_mm = args.tolerance_mm;
  plan.settings.ink.shared_samples = args.shared_samples;
  plan.settings.ink.filter_artefacts = args.filter;
  plan.settings.mm_per_unit = args.mm_per_unit;
  plan.settings.refine = !args.no_refine;
  if (!args.steady.empty()) {
    const Result<Shake> shake = shake_of(args.steady);
    if (!shake) throw UsageError(with_context(shake.error(), "--steady"));
    plan.settings.steady = *shake;
  }
  plan.settings.measure = !args.stats.empty();
  if (!args.output.empty()) {
    const Result<Format> format = output_format(args.output, args.to);
    if (!format) throw UsageError(format.error().message);
    plan.format = *format;
    plan.settings.format = stroke_format(args.output, *format);
  }
  const Result<PictureOptions> picture = args.picture.parse(console);
  if (!picture) throw UsageError(picture.error());
  plan.picture = *picture;
  const int cores = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  plan.jobs = args.jobs == 0 ? cores : args.jobs;
  return plan;
}

/// Collects the faults of the samples of one input after the other, and prints them with their
/// numbers.
class FaultNotices {
 public:
  explicit FaultNotices(Console& console) : console_(console) {}

  void add(const FitOutput& fitted) {
    if (fitted.name != name_) print();
    name_ = fitted.name;
    for (const ImportNotice& fault : fitted.faults) {
      report_.add(fault.line, fault.element, fault.what);
    }
  }
  void print() {
    for (const ImportNotice& notice : report_.notices()) {
      console_.notice(name_ + ": " + notice_text(notice));
    }
    report_ = {};
  }

 private:
  Console& console_;
  std::string name_;
  ImportReport report_;
};

/// Fits all inputs and writes them to `output`; without an output, only counts them. Returns false
/// if writing failed.
bool fit_all(const FitArguments& args, const FitPlan& plan, DrawingOutput* output, Console& console,
             FitStats& stats) {
  FitSource source(args.inputs, plan.settings);
  FaultNotices faults(console);
  bool written = true;
  OrderedPipeline<FitItem, FitOutput> pipeline(plan.jobs);
  const auto take = [&](const FitOutput& fitted) {
    for (const std::string& notice : fitted.notices) console.notice(notice);
    faults.add(fitted);
    for (const FitError& e : fitted.errors) console.record_error(fitted.name, e.line, e.what);
    stats.add(fitted.stats);
    const Result<void> appended = output ? output->append(fitted.sketch) : Result<void>();
    if (!appended) console.error(appended.error().message);
    console.progress("fitting", source.bytes_read(), source.total_bytes(), stats.strokes);
    return written = appended.has_value();
  };
  pipeline.run([&plan] { return FitWorker(plan.settings); },
               [&source](FitItem& item) { return source.next(item); }, take);
  console.end_progress();
  console.end_records();
  faults.print();
  return written;
}

void run_fit(const FitArguments& args, Console& console) {
  const FitPlan plan = plan_of(args, console);
  std::optional<DrawingOutput> output;
  if (plan.format) {
    Result<DrawingOutput> opened =
        DrawingOutput::create(args.output, *plan.format, plan.picture, OutputUse::kStrokes);
    if (!opened) return console.error(opened.error().message);
    output.emplace(*std::move(opened));
  }
  FitStats stats;
  if (!fit_all(args, plan, output ? &*output : nullptr, console, stats)) return;
  // If an error prevented all strokes from being fitted, keeps an existing output file instead of
  // replacing it by an empty one.
  if (stats.strokes == 0 && console.failed()) return;
  if (output) {
    if (Result<void> done = output->finish(); !done) return console.error(done.error().message);
    note_losses(args.output, output->lost(), console);
  }
  if (!args.stats.empty()) print("{}", stats_json(stats));
}

}  // namespace

void add_fit_command(CLI::App& app, Console& console) {
  CLI::App* command = app.add_subcommand("fit", "Turn raw pen strokes into a sketch");
  const auto args = std::make_shared<FitArguments>();
  add_options(*command, *args);
  command->footer(examples(kFitExamples));
  command->callback([args, &console] { run_fit(*args, console); });
}

}  // namespace felt::cli
