#include <fmt/core.h>

#include <charconv>
#include <memory>
#include <optional>
#include <string_view>
#include <utility>

#include "commands.h"
#include "felt/timelapse/timelapse_film.h"
#include "input.h"
#include "interrupt.h"
#include "overwrite_check.h"
#include "picture.h"
#include "timelapse_input.h"

namespace felt::cli {
namespace {

struct TimelapseArguments {
  std::string input, output, to, on;
  std::optional<double> seconds;
  int fps = 24;
  std::optional<int> hold;
  std::string size = "1280";
  PictureArguments picture;
};

constexpr int kMaxHold =
    static_cast<int>(FilmLength::kMaxSeconds) * FilmOptions::kMaxFramesPerSecond;

constexpr const char* kTimelapseExamples =
    "feltline timelapse drawing.felt -o drawing.webm\n"
    "feltline timelapse drawing.felt -o drawing.gif --seconds 10 --fps 12 --size 640\n"
    "feltline timelapse recording.ndjson -o film.webm --size 1920x1080 --page fit\n"
    "feltline timelapse strokes.ndjson -o animated.svg";

void add_options(CLI::App& command, TimelapseArguments& args) {
  command
      .add_option("INPUT", args.input,
                  "A .felt with a recording, or a recording or event script (.ndjson);\n"
                  "'-' is stdin")
      ->required();
  command.add_option("-o,--output", args.output, "The film: .webm, .gif or .svg; '-' is stdout")
      ->required();
  command
      .add_option("--to", args.to, "Format of the film; the default is set by the file extension")
      ->check(CLI::IsMember({"webm", "gif", "svg"}));
  command.add_option("--on", args.on, "A drawing that a script begins with: .felt, .ndjson, .svg");
  command
      .add_option("--seconds", args.seconds,
                  "Length of the film (default: 30, or less if the drawing took less time)")
      ->check(number_between(FilmLength::kMinSeconds, FilmLength::kMaxSeconds));
  command.add_option("--fps", args.fps, "Frames per second")
      ->check(CLI::Range(1, FilmOptions::kMaxFramesPerSecond))
      ->capture_default_str();
  command
      .add_option(
          "--hold", args.hold,
          "Frames for which the finished drawing stays at the end (default: those of 1 s): a part\n"
          "of the film, at most half")
      ->check(CLI::Range(0, kMaxHold));
  command
      .add_option("--size", args.size,
                  "Size in pixels: WxH, or the longer side; the drawing is in the middle")
      ->capture_default_str();
  command.add_option(
      "--page", args.picture.page,
      "What to show: 'fit' (everything that was ever drawn, and a margin), A0..A6,\n"
      "A4-landscape, or WxH in mm; default: the drawing's page, or fit if it has none");
  command.add_option(
      "--paper", args.picture.paper,
      "Colour behind the ink: #rrggbb or white; default: that of the page, or white");
  command
      .add_option("--surface", args.picture.surface,
                  "Surface whose grain shows in dry ink, as in 'feltline render'")
      ->check(not_empty());
  command.add_flag("--grain", args.picture.grain,
                   "Show the grain of the drawing's surface in dry ink");
}

TimelapseFormat format_of(const TimelapseArguments& args) {
  const std::string name = args.to.empty() ? args.output : "film." + args.to;
  if (const std::optional<TimelapseFormat> format = timelapse_format_of(name)) return *format;
  throw UsageError(args.output + ": a film is a .webm, a .gif or an .svg (--to)");
}

std::optional<int> side_of(std::string_view text) {
  int side = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), side);
  const bool fits = error == std::errc() && end == text.data() + text.size() &&
                    side >= FilmOptions::kMinSidePx && side <= FilmOptions::kMaxSidePx;
  return fits ? std::optional(side) : std::nullopt;
}

/// Returns the size that the option --size gives for an area.
FilmSize size_of(const std::string& text, const Rect& area) {
  const std::size_t cross = text.find('x');
  if (cross != std::string::npos) {
    const auto width = side_of(std::string_view(text).substr(0, cross));
    const auto height = side_of(std::string_view(text).substr(cross + 1));
    if (width && height) return {*width, *height};
  } else if (const std::optional<int> longer = side_of(text)) {
    return film_size(*longer, area);
  }
  throw UsageError(fmt::format("--size: '{}' is not WxH or a number, of {} to {} pixels", text,
                               FilmOptions::kMinSidePx, FilmOptions::kMaxSidePx));
}

/// Everything that is known before the first frame.
struct FilmPlan {
  PictureOptions look;  // the grain refers to its relief
  TimelapseSurvey survey;
  TimelapseFilm film;
};

/// Returns the colour of the paper. Films have no transparency; an .svg does.
Rgba paper_of(const PictureOptions& look, const Drawing& frame, TimelapseFormat format) {
  const Rgba paper = look.paper.value_or(frame.has_page ? frame.page.paper : Rgba{255, 255, 255});
  if (format == TimelapseFormat::kSvg || paper.a == 255) return paper;
  if (look.paper) throw UsageError("--paper: a .webm or .gif film cannot be transparent");
  return {255, 255, 255, 255};
}

Result<FilmPlan> plan_film(const TimelapseArguments& args, TimelapseFormat format,
                           const TimelapseInput& input, Console& console) {
  Result<PictureOptions> look = args.picture.parse(console);
  if (!look) throw UsageError(look.error());
  FilmPlan plan;
  plan.look = *std::move(look);
  TimelapseFilm& film = plan.film;
  film.format = format;
  film.length = {args.seconds, args.fps,
                 static_cast<double>(args.hold.value_or(args.fps)) / args.fps};
  film.paper = paper_of(plan.look, input.frame, format);
  const bool shows_page = !plan.look.fit && (plan.look.area || input.frame.has_page);
  // Playing the recording takes as long as making the film, so it is only done if needed.
  if (shows_page && format != TimelapseFormat::kGif && !args.picture.grain &&
      args.picture.surface.empty()) {
    plan.survey = measure_recording(input.source.recording);
  } else {
    Result<TimelapseSurvey> survey = survey_recording(input.source);
    if (!survey) return tl::unexpected(with_context(survey.error(), input_name(args.input)));
    plan.survey = *std::move(survey);
    if (auto known = use_surface_of(plan.survey.end, plan.look); !known) {
      return tl::unexpected(known.error());
    }
  }
  film.grain = plan.look.grain;
  const Rect ink = plan.survey.ink.empty() ? Rect{0.0, 0.0, 0.0, 0.0} : plan.survey.ink;
  film.area = plan.look.area ? *plan.look.area
              : shows_page   ? input.frame.page.area()
                             : ink.inflated(kFilmMarginMm);
  film.size = size_of(args.size, film.area);
  film.on_frame = [&console](std::int64_t done, std::int64_t all) {
    console.status(fmt::format("frame {} of {}", done, all));
  };
  return plan;
}

void run_timelapse(const TimelapseArguments& args, Console& console) {
  const TimelapseFormat format = format_of(args);
  (void)size_of(args.size, {0.0, 0.0, 1.0, 1.0});  // reports an error before the input is read
  check_no_overwrite({args.input, args.on.empty() ? args.input : args.on}, {{"-o", args.output}},
                     console);
  Result<TimelapseInput> input = read_timelapse({args.input, args.on, args.output}, console);
  if (!input) return console.error(input.error().message);
  if (console.failed()) return;  // a notice with --strict
  const Result<FilmPlan> plan = plan_film(args, format, *input, console);
  if (!plan) return console.error(plan.error().message);
  const Interrupt interrupt;
  input->source.is_cancelled = [] { return Interrupt::was_asked(); };
  const Result<void> done =
      write_timelapse(args.output, input_name(args.input), input->source, plan->survey, plan->film);
  console.end_progress();
  if (!done) console.error(done.error().message);
}

}  // namespace

void add_timelapse_command(CLI::App& app, Console& console) {
  CLI::App* command = app.add_subcommand("timelapse", "Make a film of how a drawing was made");
  const auto args = std::make_shared<TimelapseArguments>();
  add_options(*command, *args);
  command->footer(examples(kTimelapseExamples));
  command->callback([args, &console] { run_timelapse(*args, console); });
}

}  // namespace felt::cli
