#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <memory>
#include <optional>
#include <string_view>
#include <utility>

#include "commands.h"
#include "felt/base/ascii.h"
#include "felt/film/film_writer.h"
#include "felt/timelapse/animated_svg.h"
#include "input.h"
#include "interrupt.h"
#include "output.h"
#include "overwrite_check.h"
#include "picture.h"
#include "timelapse_input.h"

namespace felt::cli {
namespace {

struct TimelapseArguments {
  std::string input, output, to, on;
  std::optional<double> seconds;
  int fps = 24;
  double hold_s = 1.0;
  std::string size = "1280";
  PictureArguments picture;
};

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
          "--hold", args.hold_s,
          "How long the finished drawing stays at the end, in s: a part of the film, at most half")
      ->check(number_between(0.0, FilmLength::kMaxSeconds))
      ->capture_default_str();
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

enum class Kind { kWebm, kGif, kSvg };

Kind kind_of(const TimelapseArguments& args) {
  const std::string name = args.to.empty() ? args.output : "." + args.to;
  std::string path = args.to.empty() ? name : "film" + name;
  if (const std::optional<FilmFormat> film = film_format_of(path)) {
    return *film == FilmFormat::kGif ? Kind::kGif : Kind::kWebm;
  }
  std::transform(path.begin(), path.end(), path.begin(), ascii_lower);
  if (path.ends_with(".svg")) return Kind::kSvg;
  throw UsageError(args.output + ": a film is a .webm, a .gif or an .svg (--to)");
}

struct FilmSize {
  int width_px = 0, height_px = 0;
};

std::optional<int> side_of(std::string_view text) {
  int side = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), side);
  const bool fits = error == std::errc() && end == text.data() + text.size() &&
                    side >= FilmOptions::kMinSidePx && side <= FilmOptions::kMaxSidePx;
  return fits ? std::optional(side) : std::nullopt;
}

/// Returns the size that the option --size gives for an area. If only the longer side is given, the
/// other one is even, because many players need that.
FilmSize size_of(const std::string& text, const Rect& area) {
  const std::size_t cross = text.find('x');
  if (cross != std::string::npos) {
    const auto width = side_of(std::string_view(text).substr(0, cross));
    const auto height = side_of(std::string_view(text).substr(cross + 1));
    if (width && height) return {*width, *height};
  } else if (const std::optional<int> longer = side_of(text)) {
    const double width_mm = std::max(area.width(), 1.0), height_mm = std::max(area.height(), 1.0);
    const double share = std::min(width_mm, height_mm) / std::max(width_mm, height_mm);
    const int shorter =
        std::max(2 * static_cast<int>(std::lround(0.5 * share * *longer)), FilmOptions::kMinSidePx);
    return width_mm >= height_mm ? FilmSize{*longer, shorter} : FilmSize{shorter, *longer};
  }
  throw UsageError(fmt::format("--size: '{}' is not WxH or a number, of {} to {} pixels", text,
                               FilmOptions::kMinSidePx, FilmOptions::kMaxSidePx));
}

/// Everything that is known before the first frame.
struct FilmPlan {
  TimelapseSurvey survey;
  PictureOptions look;
  Rgba paper;
  Rect area;
  FilmSize size;
};

/// Returns the colour of the paper. Films have no transparency; an .svg does.
Rgba paper_of(const PictureOptions& look, const Drawing& frame, Kind kind) {
  const Rgba paper = look.paper.value_or(frame.has_page ? frame.page.paper : Rgba{255, 255, 255});
  if (kind == Kind::kSvg || paper.a == 255) return paper;
  if (look.paper) throw UsageError("--paper: a .webm or .gif film cannot be transparent");
  return {255, 255, 255, 255};
}

Result<FilmPlan> plan_film(const TimelapseArguments& args, Kind kind, const TimelapseInput& input,
                           Console& console) {
  Result<PictureOptions> look = args.picture.parse(console);
  if (!look) throw UsageError(look.error());
  FilmPlan plan;
  plan.look = *std::move(look);
  plan.paper = paper_of(plan.look, input.frame, kind);
  const bool shows_page = !plan.look.fit && (plan.look.area || input.frame.has_page);
  // Playing the recording takes as long as making the film, so it is only done if needed.
  if (shows_page && kind != Kind::kGif && !args.picture.grain && args.picture.surface.empty()) {
    plan.survey = measure_recording(input.source.recording);
  } else {
    Result<TimelapseSurvey> survey = survey_recording(input.source);
    if (!survey) return tl::unexpected(with_context(survey.error(), input_name(args.input)));
    plan.survey = *std::move(survey);
    if (auto known = use_surface_of(plan.survey.end, plan.look); !known) {
      return tl::unexpected(known.error());
    }
  }
  const Rect ink = plan.survey.ink.empty() ? Rect{0.0, 0.0, 0.0, 0.0} : plan.survey.ink;
  plan.area = plan.look.area ? *plan.look.area
              : shows_page   ? input.frame.page.area()
                             : ink.inflated(kFilmMarginMm);
  plan.size = size_of(args.size, plan.area);
  return plan;
}

Result<void> write_svg(const TimelapseArguments& args, const TimelapseInput& input,
                       const FilmPlan& plan, const FilmTiming& timing) {
  Result<Output> output = Output::create(args.output);
  if (!output) return tl::unexpected(output.error());
  const Result<PageOptions> page =
      page_in_frame(plan.area, plan.size.width_px, plan.size.height_px);
  if (!page) return tl::unexpected(page.error());
  const Result<std::string> text = animated_svg(
      input.source, timing, {*page->area, plan.paper, plan.size.width_px, plan.size.height_px});
  if (!text) return tl::unexpected(with_context(text.error(), input_name(args.input)));
  return output->write_all(*text);
}

Result<void> write_film(const TimelapseArguments& args, Kind kind, const TimelapseInput& input,
                        const FilmPlan& plan, const FilmTiming& timing, Console& console) {
  Result<PageOptions> page = page_in_frame(plan.area, plan.size.width_px, plan.size.height_px);
  if (!page) return tl::unexpected(page.error());
  page->paper = plan.paper;
  page->grain = plan.look.grain;
  FilmOptions options;
  options.format = kind == Kind::kGif ? FilmFormat::kGif : FilmFormat::kWebm;
  options.width_px = plan.size.width_px;
  options.height_px = plan.size.height_px;
  options.frames_per_second = args.fps;
  options.is_cancelled = [] { return Interrupt::was_asked(); };
  std::optional<Image> colors;
  if (kind == Kind::kGif) {
    Result<Image> last = render_page(plan.survey.end.document, *page, PictureChoice::kMarked);
    if (!last) return tl::unexpected(last.error());
    colors = *std::move(last);
  }
  const Interrupt interrupt;
  Result<FilmWriter> film = FilmWriter::create(args.output, options, colors ? &*colors : nullptr);
  if (!film) return tl::unexpected(film.error());
  std::int64_t done = 0;
  const FrameSink add = [&](const Image& frame) -> Result<void> {
    if (Interrupt::was_asked()) return fail(ErrorCode::kIo, args.output + ": cancelled");
    console.status(fmt::format("frame {} of {}", ++done, timing.frames()));
    return film->add(frame);
  };
  const Result<void> played = play_timelapse(input.source, timing, *page, add);
  console.end_progress();
  if (!played) return played;
  return film->finish();
}

void run_timelapse(const TimelapseArguments& args, Console& console) {
  const Kind kind = kind_of(args);
  (void)size_of(args.size, {0.0, 0.0, 1.0, 1.0});  // reports an error before the input is read
  check_no_overwrite({args.input, args.on.empty() ? args.input : args.on}, {{"-o", args.output}},
                     console);
  const Result<TimelapseInput> input = read_timelapse({args.input, args.on, args.output}, console);
  if (!input) return console.error(input.error().message);
  const Result<FilmPlan> plan = plan_film(args, kind, *input, console);
  if (!plan) return console.error(plan.error().message);
  const FilmTiming timing(plan->survey.drawing_ns, {args.seconds, args.fps, args.hold_s});
  const Result<void> done = kind == Kind::kSvg
                                ? write_svg(args, *input, *plan, timing)
                                : write_film(args, kind, *input, *plan, timing, console);
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
