#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "commands.h"
#include "drawing_output.h"
#include "felt/base/numbered_names.h"
#include "felt/base/same_file.h"
#include "felt/document/visible_strokes.h"
#include "felt/formats/drawing_writer.h"
#include "felt/formats/format_traits.h"
#include "felt/formats/lost_objects.h"
#include "felt/io/drawing_parts.h"
#include "felt/io/svg/svg_animated.h"
#include "felt/motion/key_layers.h"
#include "felt/motion/stroke_shape.h"
#include "felt/timelapse/timelapse_film.h"
#include "format.h"
#include "inbetween_pairs.h"
#include "input.h"
#include "output.h"
#include "overwrite_check.h"
#include "picture.h"
#include "sketch_input.h"

namespace felt::cli {
namespace {

/// The options and arguments of the command line.
struct InbetweenArguments {
  std::vector<std::string> inputs;
  std::string output;
  std::string to;
  std::string matches;
  std::optional<std::string> ease;
  std::string lone = "fade";
  std::vector<std::string> pairs;
  std::optional<int> frames;
  std::optional<int> hold;
  double fps = 24.0;
  bool keys = false;
  PictureArguments picture;
};

void add_film_options(CLI::App& command, InbetweenArguments& args) {
  command
      .add_option("--frames", args.frames,
                  "In-betweens from one key drawing to the next; 12, or those of the layers")
      ->check(CLI::Range(1, 10000));
  command.add_option(
      "--ease", args.ease,
      "Speed of the motion: linear, ease, ease-in, ease-out, ease-in-out, four\n"
      "numbers as of CSS cubic-bezier (0.4,0,0.6,1), or a drawing whose first stroke\n"
      "goes from the start (time 0) to the end; linear, or that of the layers");
  command
      .add_option("--hold", args.hold,
                  "Frames for which an animated .svg shows each key drawing; 1, or those of\n"
                  "the layers")
      ->check(CLI::Range(1, 10000));
  command.add_option("--fps", args.fps, "Frames a second of an animated .svg")
      ->check(number_between(1.0, 240.0))
      ->capture_default_str();
  command.add_flag("--keys", args.keys, "Also write the key drawings as numbered files");
}

void add_options(CLI::App& command, InbetweenArguments& args) {
  command
      .add_option("IN", args.inputs,
                  "Two or more key drawings, in their order; or one drawing whose unlocked layers\n"
                  "are the key drawings, from the bottom up. Formats: " +
                      readable_names())
      ->required()
      ->expected(1, 1000);
  command
      .add_option(
          "-o,--output", args.output,
          "Numbered files such as walk-%03d.svg, a folder, or one animated .svg. Formats of\n"
          "numbered files: " +
              writable_names())
      ->required();
  command.add_option("--to", args.to,
                     "Format of the files; the default is set by the file extension, in a folder "
                     "svg");
  command.add_option(
      "--pair", args.pairs,
      "These strokes belong together, whatever they look like: FROM:TO with the ids\n"
      "of --matches, such as 3:5; 3:none: without partner; 2:3:5: in the second step");
  command.add_option("--matches", args.matches,
                     "Also write which strokes belong together, as .csv");
  command
      .add_option("--lone", args.lone,
                  "How strokes come and go that only one key drawing has: fade or grow")
      ->check(CLI::IsMember({"fade", "grow"}))
      ->capture_default_str();
  add_film_options(command, args);
  args.picture.add_to(command);
}

/// Where the drawings go.
struct FilmOutput {
  std::optional<NumberedNames> names;  ///< absent: one animated .svg
  Format format = Format::kSvg;
};

/// Returns the output that the arguments name. Throws a UsageError if they name none.
FilmOutput film_output(const InbetweenArguments& args) {
  FilmOutput output;
  std::string path = args.output;
  std::error_code ignored;
  if (path.ends_with('/') || std::filesystem::is_directory(path, ignored)) {
    const std::string ending = args.to.empty() ? "svg" : args.to;
    path += (path.ends_with('/') ? "inbetween-%03d." : "/inbetween-%03d.") + ending;
  }
  output.names = NumberedNames::parse(path);
  const Result<Format> format = output_format(path, args.to);
  if (!format) throw UsageError(format.error().message);
  output.format = *format;
  if (!output.names && *format != Format::kSvg) {
    throw UsageError("-o must be numbered files such as walk-%03d.png, a folder, or one .svg");
  }
  return output;
}

Result<Ease> parse_ease(const std::string& text) {
  Result<Ease> ease = Ease::parse(text);
  std::error_code ignored;
  if (ease || !std::filesystem::exists(text, ignored)) return ease;
  const Result<Imported> opened =
      Input::open(text).and_then([](const Input& input) { return input.read_drawing({}); });
  if (!opened) return fail(ErrorCode::kInvalidData, text + ": " + opened.error().message);
  const std::vector<StrokePtr> strokes = visible_strokes(opened->drawing.document);
  if (strokes.empty()) return fail(ErrorCode::kInvalidData, text + ": contains no strokes");
  ease = Ease::drawn(coarse_line(*strokes.front()));
  if (!ease) return fail(ErrorCode::kInvalidData, text + ": " + ease.error().message);
  return ease;
}

/// Makes the film of one command line.
class FilmMaker {
 public:
  FilmMaker(const InbetweenArguments& args, FilmOutput output, PictureOptions picture,
            std::optional<Ease> ease, std::vector<PairArgument> pairs)
      : args_(args),
        output_(std::move(output)),
        picture_(std::move(picture)),
        ease_(std::move(ease)),
        pairs_(std::move(pairs)),
        table_(matches_header()) {}

  /// Returns false if a key drawing cannot be read; the console has the reason.
  bool read_keys(Console& console);
  /// Throws a UsageError if a file that is written is also read, or is written twice.
  void check_files(Console& console) const;
  /// Returns the number of numbered files that make() writes.
  [[nodiscard]] std::size_t file_count() const;
  Result<void> make();
  /// Prints what the first numbered file that cannot contain everything leaves out.
  void print_losses(Console& console) const { note_losses(loses_, lost_, console); }

 private:
  bool add_layers(const Drawing& drawing, Console& console);
  [[nodiscard]] KeySettings settings(const FilmKey& key) const;
  [[nodiscard]] std::string name_of_key(std::size_t i) const;
  void find_area();
  [[nodiscard]] Result<void> check_pairs() const;
  Result<void> add_key(std::size_t i, KeyFilm& film);
  Result<void> add(Drawing drawing, int frames, bool is_key);
  Result<void> write_numbered(const Drawing& drawing);
  Result<void> write_film() const;

  const InbetweenArguments& args_;
  FilmOutput output_;
  PictureOptions picture_;
  std::optional<Ease> ease_;  // absent: that of each key drawing
  std::vector<PairArgument> pairs_;
  std::vector<FilmKey> keys_;
  std::optional<Rect> area_;  // if absent, the page is shown
  std::vector<AnimatedPicture> pictures_;
  std::size_t written_ = 0;
  std::string loses_;  // the first file that leaves something out
  LostObjects lost_;
  std::string table_;
};

bool FilmMaker::read_keys(Console& console) {
  for (const std::string& path : args_.inputs) {
    const Result<Input> input = Input::open(path);
    if (!input) {
      console.error(input_name(path) + ": " + input.error().message);
      return false;
    }
    Result<Imported> opened = input->read_drawing({});
    if (!opened) {
      console.error(input->name() + ": " + opened.error().message);
      return false;
    }
    if (!report_notices(input->name(), opened->report, console)) return false;
    if (args_.inputs.size() == 1) return add_layers(opened->drawing, console);
    keys_.push_back({std::move(opened->drawing)});
  }
  return true;
}

/// Makes the layers of a drawing the key drawings.
bool FilmMaker::add_layers(const Drawing& drawing, Console& console) {
  keys_ = film_keys(drawing.document, drawing.page);
  for (FilmKey& key : keys_) {
    key.drawing.has_page = drawing.has_page;
    key.drawing.materials = drawing.materials;
    key.drawing.names = drawing.names;
  }
  if (keys_.size() >= 2) return true;
  console.error(input_name(args_.inputs.front()) +
                ": has fewer than two key drawings: layers with lines that are not locked");
  return false;
}

/// All pictures show the same area: the page of the first drawing, or the ink of all.
void FilmMaker::find_area() {
  if (picture_.area) {
    area_ = picture_.area;
    return;
  }
  if (keys_.front().drawing.has_page && !picture_.fit) return;
  Rect ink;
  for (const FilmKey& key : keys_) ink.extend(ink_bounds(key.drawing.document));
  area_ = picture_area(ink, std::nullopt, kFilmMarginMm);
}

Result<void> FilmMaker::write_numbered(const Drawing& drawing) {
  WriteOptions options;
  options.area = area_;
  options.dpi = picture_.dpi;
  options.paper = picture_.paper;
  if (!picture_.paper && !drawing.has_page && output_.format != Format::kPng) {
    options.paper = Rgba{255, 255, 255, 0};
  }
  options.pictures = picture_.pictures;
  if (auto ok = use_surface_of(drawing, picture_); !ok) return ok;
  options.grain = picture_.grain;
  const std::string path = output_.names->name(++written_);
  if (lost_ == LostObjects()) {
    lost_ = lost_objects(drawing, output_.format);
    loses_ = path;
  }
  return drawing_bytes(drawing, output_.format, options)
      .map_error([&](Error error) { return with_context(std::move(error), path); })
      .and_then([&](const std::string& bytes) {
        return Output::create(path).and_then(
            [&](Output output) { return output.write_all(bytes); });
      });
}

Result<void> FilmMaker::add(Drawing drawing, int frames, bool is_key) {
  if (output_.names) return !is_key || args_.keys ? write_numbered(drawing) : Result<void>();
  pictures_.push_back({std::move(drawing), frames});
  return {};
}

/// Returns the timing of a key drawing, or the options instead.
KeySettings FilmMaker::settings(const FilmKey& key) const {
  KeySettings settings = settings_of(key.timing);
  settings.between = args_.frames.value_or(settings.between);
  settings.hold = args_.hold.value_or(settings.hold);
  if (ease_) settings.ease = *ease_;
  return settings;
}

std::string FilmMaker::name_of_key(std::size_t i) const {
  return args_.inputs.size() > 1 ? args_.inputs[i] : keys_[i].drawing.document.layers()[0].name;
}

/// Adds the pairs of a timing whose strokes the options do not mention.
void add_other_pairs(std::vector<GivenPair>& given, const std::vector<GivenPair>& of_timing) {
  const std::size_t count = given.size();
  for (const GivenPair& pair : of_timing) {
    const auto is_mentioned = [&pair](const GivenPair& other) {
      return (pair.from && pair.from == other.from) || (pair.to && pair.to == other.to);
    };
    const auto end = given.begin() + static_cast<std::ptrdiff_t>(count);
    if (std::none_of(given.begin(), end, is_mentioned)) given.push_back(pair);
  }
}

/// Adds a key drawing and, unless it is the first one, the step to it.
Result<void> FilmMaker::add_key(std::size_t i, KeyFilm& film) {
  if (i == 0) return film.add(keys_[0].drawing, settings(keys_[0]));
  const std::size_t step = i - 1;
  const KeyStrokes a = key_strokes(keys_[step].drawing.document),
                   b = key_strokes(keys_[i].drawing.document);
  Result<std::vector<GivenPair>> given = pairs_of_step(pairs_, step, a, b);
  if (!given) return tl::unexpected(given.error());
  add_other_pairs(*given, given_pairs(keys_[step].timing, a, b));
  Result<void> added = film.add(keys_[i].drawing, settings(keys_[i]), *std::move(given));
  if (!added) {
    return tl::unexpected(with_context(added.error(), name_of_key(step) + " to " + name_of_key(i)));
  }
  table_ += matches_rows(film.correspondence(step), step, a, b);
  return {};
}

/// Checks the pairs of all steps, so that a wrong one is reported before a file is written.
Result<void> FilmMaker::check_pairs() const {
  for (std::size_t step = 0; step + 1 < keys_.size(); ++step) {
    const auto given = pairs_of_step(pairs_, step, key_strokes(keys_[step].drawing.document),
                                     key_strokes(keys_[step + 1].drawing.document));
    if (!given) return tl::unexpected(given.error());
  }
  for (const PairArgument& pair : pairs_) {
    if (pair.step >= keys_.size() - 1) {
      return fail(ErrorCode::kInvalidArgument,
                  fmt::format("--pair: the number of steps is {}", keys_.size() - 1));
    }
  }
  return {};
}

/// Checks everything that could fail later, writes the drawings, and then the table of matches.
Result<void> FilmMaker::make() {
  if (auto ok = check_pairs(); !ok) return ok;
  if (output_.names && file_count() == 0) {
    return fail(ErrorCode::kInvalidArgument,
                "no file to write: the key drawings have no in-betweens; --keys writes the key "
                "drawings, and --frames sets the number of in-betweens");
  }
  std::optional<Output> matches;
  if (!args_.matches.empty()) {
    Result<Output> created = Output::create(args_.matches);
    if (!created) return tl::unexpected(created.error());
    matches.emplace(*std::move(created));
  }
  find_area();
  const LoneStroke lone = args_.lone == "grow" ? LoneStroke::kGrow : LoneStroke::kFade;
  KeyFilm film(lone);
  for (std::size_t i = 0; i < keys_.size(); ++i) {
    if (auto ok = add_key(i, film); !ok) return ok;
  }
  for (std::size_t i = 0; i < film.size(); ++i) {
    if (auto ok = add(film.picture(i), film.frames(i), film.is_key(i)); !ok) return ok;
  }
  if (!output_.names) {
    if (auto ok = write_film(); !ok) return ok;
  }
  return matches ? matches->write_all(table_) : Result<void>();
}

Result<void> FilmMaker::write_film() const {
  const Drawing& first = keys_.front().drawing;
  AnimatedSvgOptions options;
  options.area = area_.value_or(first.page.area());
  if (picture_.paper) options.paper = *picture_.paper;
  if (!picture_.paper && first.has_page) options.paper = first.page.paper;
  options.frames_per_second = args_.fps;
  return svg_animated_text(pictures_, options).and_then([&](const std::string& text) {
    return Output::create(args_.output).and_then([&](Output out) { return out.write_all(text); });
  });
}

std::size_t FilmMaker::file_count() const {
  std::size_t count = args_.keys ? keys_.size() : 0;
  for (std::size_t i = 0; i + 1 < keys_.size(); ++i) {
    count += static_cast<std::size_t>(settings(keys_[i]).between);
  }
  return count;
}

void FilmMaker::check_files(Console& console) const {
  std::vector<std::string> inputs = args_.inputs;
  std::error_code ignored;
  if (args_.ease && !Ease::parse(*args_.ease) && std::filesystem::exists(*args_.ease, ignored)) {
    inputs.push_back(*args_.ease);
  }
  check_no_overwrite(
      inputs, {{"-o", output_.names ? "" : args_.output}, {"--matches", args_.matches}}, console);
  if (!output_.names) return;
  for (std::size_t number = 1; number <= file_count(); ++number) {
    const std::string name = output_.names->name(number);
    check_no_overwrite(inputs, {{"-o", name}}, console);
    if (args_.matches.empty() || !is_same_file(name, args_.matches)) continue;
    throw UsageError(
        fmt::format("-o {} and --matches {} are the same file; nothing was written. "
                    "Choose different files",
                    name, args_.matches));
  }
}

void run_inbetween(const InbetweenArguments& args, Console& console) {
  if (args.output == "-" && args.matches == "-") {
    throw UsageError("-o - and --matches - cannot both use stdout");
  }
  FilmOutput output = film_output(args);
  std::vector<PairArgument> pairs;
  for (const std::string& text : args.pairs) {
    Result<PairArgument> pair = parse_pair(text);
    if (!pair) throw UsageError(pair.error().message);
    pairs.push_back(*std::move(pair));
  }
  Result<PictureOptions> picture = args.picture.parse(console);
  if (!picture) throw UsageError(picture.error());
  std::optional<Ease> ease;
  if (args.ease) {
    Result<Ease> parsed = parse_ease(*args.ease);
    if (!parsed) throw UsageError("--ease: " + parsed.error().message);
    ease = *std::move(parsed);
  }
  FilmMaker film(args, std::move(output), *std::move(picture), std::move(ease), std::move(pairs));
  if (!film.read_keys(console)) return;
  film.check_files(console);
  if (const Result<void> made = film.make(); !made) return console.error(made.error().message);
  film.print_losses(console);
}

}  // namespace

void add_inbetween_command(CLI::App& app, Console& console) {
  CLI::App* command =
      app.add_subcommand("inbetween", "Make the drawings between two or more key drawings");
  const auto args = std::make_shared<InbetweenArguments>();
  add_options(*command, *args);
  command->footer(examples(
      "feltline inbetween fish-1.svg fish-2.svg -o swim-%03d.svg --frames 12\n"
      "feltline inbetween fish-1.svg fish-2.svg fish-1.svg -o swim.svg --ease ease-in-out\n"
      "feltline inbetween a.felt b.felt -o frames/ --to png --keys --dpi 96\n"
      "feltline inbetween a.felt b.felt -o ab.svg --pair 3:5 --matches matches.csv\n"
      "feltline inbetween walk.felt -o walk.svg"));
  command->callback([args, &console] { run_inbetween(*args, console); });
}

}  // namespace felt::cli
