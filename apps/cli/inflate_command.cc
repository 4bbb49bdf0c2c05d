#include <fmt/core.h>

#include <memory>
#include <optional>
#include <string_view>

#include "commands.h"
#include "felt/film/film_writer.h"
#include "felt/formats/drawing_grain.h"
#include "felt/formats/format_traits.h"
#include "felt/io/picture/png.h"
#include "felt/solid/body_edits.h"
#include "felt/solid/front_paint.h"
#include "felt/solid/gap_search.h"
#include "felt/solid/inflate.h"
#include "felt/solid/solid_picture.h"
#include "felt/solid/solid_writer.h"
#include "input.h"
#include "output.h"
#include "overwrite_check.h"
#include "sketch_input.h"
#include "solid_film.h"

namespace felt::cli {
namespace {

constexpr const char* kSolidFormats = ".stl, .obj, .3mf or .glb";
constexpr double kSolidPictureDpi = 96.0;

/// The options and arguments of the command line.
struct InflateArguments {
  std::string input;
  std::string output;
  std::string to;
  std::string png;
  std::string film;
  InflateOptions options;
  std::optional<double> gap_mm;
  bool fills_holes = false;
  bool paints = true;
  bool edits = true;
};

void add_options(CLI::App& command, InflateArguments& args) {
  command
      .add_option("IN", args.input,
                  "The drawing ('-' is stdin). Its format is detected from its content: " +
                      readable_names())
      ->required();
  command.add_option("-o,--output", args.output,
                     std::string("Output file: ") + kSolidFormats + "; '-' is stdout (with --to)");
  command.add_option("--to", args.to,
                     std::string("Output format: ") + kSolidFormats +
                         "; the default is set by the file extension");
  command.add_option("--png", args.png, "Also, or only, paint a picture of the solid: a .png");
  command.add_option("--film", args.film,
                     "Also, or only, make a film in which the solid turns once: a .webm or .gif;\n"
                     "needs ffmpeg");
  command
      .add_option(
          "--triangles", args.options.triangles,
          "About how many triangles the solid gets; narrow parts can need more. Default: as many\n"
          "as it needs to look smooth at 1,200 pixels")
      ->check(CLI::Range(InflateOptions::kMinTriangles, InflateOptions::kMaxTriangles));
  command
      .add_option("--thickness", args.options.thickness,
                  "Factor of the thickness; with 1 a disc becomes a ball")
      ->check(number_between(0.05, 20.0))
      ->capture_default_str();
  command
      .add_option(
          "--gap", args.gap_mm,
          "Close gaps of the outline up to this size, in mm; default: the smallest of 2, 4\n"
          "and 8 that closes most of the drawing")
      ->check(number_between(0.0, 32.0));
  command.add_flag("--fill-holes", args.fills_holes,
                   "Ignore closed lines inside an outline; default: they are holes");
  command.add_flag(
      "!--no-paint", args.paints,
      "Leave the lines and fills inside the outlines out of a .glb and of the picture;\n"
      "default: they are painted on the front");
  command.add_flag(
      "!--no-edits", args.edits,
      "Leave out the cuts, extrusions, paint and smoothing that the drawing has for its\n"
      "body");
}

/// Returns the format of the output; nullopt if only a picture is wanted.
std::optional<SolidFormat> wanted_solid_format(const InflateArguments& args) {
  if (args.output.empty()) {
    if (args.png.empty() && args.film.empty()) {
      throw UsageError("-o, --png or --film is required");
    }
    if (!args.to.empty()) throw UsageError("--to needs -o");
    return std::nullopt;
  }
  const std::size_t dot = args.output.rfind('.');
  std::string_view name = args.to;
  if (name.empty() && dot != std::string::npos)
    name = std::string_view(args.output).substr(dot + 1);
  if (name.starts_with('.')) name.remove_prefix(1);
  const std::optional<SolidFormat> format = solid_format_of(name);
  if (format) return format;
  throw UsageError(args.to.empty()
                       ? fmt::format("{}: cannot choose a format; name the file {}, or use --to",
                                     args.output, kSolidFormats)
                       : fmt::format("--to: '{}' is not {}", args.to, kSolidFormats));
}

Result<void> write_picture(const Solid& solid, const FrontPaint* paint, const std::string& path) {
  return paint_solid(solid, {}, paint)
      .map_error([&](const Error& error) { return with_context(error, path); })
      .and_then([&](const Image& image) { return encode_png(image, kSolidPictureDpi); })
      .and_then([&](const std::string& bytes) {
        return Output::create(path).and_then([&](Output out) { return out.write_all(bytes); });
      });
}

Result<void> write_solid(const Solid& solid, const FrontPaint* paint, SolidFormat format,
                         const std::string& path) {
  return encode_solid(solid, format, paint)
      .map_error([&](const Error& error) { return with_context(error, path); })
      .and_then([&](const std::string& bytes) {
        return Output::create(path).and_then([&](Output out) { return out.write_all(bytes); });
      });
}

/// Returns the ink on the fronts of the bodies. If it is not written to a file, it is only needed
/// to report its loss, so an error counts as no ink and the grain is not loaded.
Result<std::optional<FrontPaint>> paint_of(const Drawing& drawing, const Solid& solid,
                                           bool is_written) {
  if (!is_written) {
    Result<std::optional<FrontPaint>> paint = front_paint(drawing.document, solid, Grain());
    return paint ? *std::move(paint) : std::nullopt;
  }
  return grain_of(drawing).and_then(
      [&](const Grain& grain) { return front_paint(drawing.document, solid, grain); });
}

/// Applies the edits of the body. Those that do not fit are reported.
void edit_solid(const Document& document, const std::string& name, Solid& solid, Console& console) {
  EditedSolid edited = apply_body_edits(std::move(solid), body_edits_of(document));
  for (const std::string& refusal : edited.refusals) {
    if (!refusal.empty()) console.notice(name + ": " + refusal);
  }
  solid = std::move(edited.solid);
}

/// Writes the files that the arguments name.
void write_outputs(const InflateArguments& args, std::optional<SolidFormat> format,
                   const Solid& solid, const FrontPaint* front, Console& console) {
  if (format) {
    const Result<void> done = write_solid(solid, front, *format, args.output);
    if (!done) return console.error(done.error().message);
  }
  if (!args.png.empty()) {
    const Result<void> done = write_picture(solid, front, args.png);
    if (!done) return console.error(done.error().message);
  }
  if (args.film.empty()) return;
  const Result<void> done = write_turning_film(solid, front, args.film);
  if (!done) console.error(done.error().message);
}

void run_inflate(InflateArguments& args, Console& console) {
  const std::optional<SolidFormat> format = wanted_solid_format(args);
  if (args.output == "-" && args.png == "-") {
    throw UsageError("-o - and --png - cannot both use stdout");
  }
  if (!args.film.empty() && !film_format_of(args.film)) {
    throw UsageError(fmt::format("--film: '{}' is not .webm or .gif", args.film));
  }
  check_no_overwrite({args.input},
                     {{"-o", args.output}, {"--png", args.png}, {"--film", args.film}}, console);
  if (args.fills_holes) args.options.holes = HoleChoice::kFill;
  const Result<Input> input = Input::open(args.input);
  if (!input) return console.error(input_name(args.input) + ": " + input.error().message);
  const Result<Imported> opened = input->read_drawing({});
  if (!opened) return console.error(input->name() + ": " + opened.error().message);
  if (!report_notices(input->name(), opened->report, console)) return;
  if (opened->drawing.document.stroke_count() == 0) {
    return console.error(input->name() + ": contains no strokes");
  }
  args.options.max_gap_mm = args.gap_mm ? *args.gap_mm : automatic_gap_mm(opened->drawing.document);
  const Document& document = opened->drawing.document;
  Result<InflatedDrawing> inflated = inflate(document, args.options);
  if (!inflated) return console.error(input->name() + ": " + inflated.error().message);
  for (const std::string& note : inflated->notes) console.notice(input->name() + ": " + note);
  if (console.failed()) return;
  const bool writes_paint = format == SolidFormat::kGlb || !args.png.empty() || !args.film.empty();
  const Result<std::optional<FrontPaint>> paint =
      args.paints ? paint_of(opened->drawing, inflated->solid, writes_paint) : std::nullopt;
  if (!paint) return console.error(input->name() + ": " + paint.error().message);
  if (args.edits) edit_solid(document, input->name(), inflated->solid, console);
  const FrontPaint* front = *paint ? &**paint : nullptr;
  if (format && loses_paint(inflated->solid, *format, front)) {
    console.notice(
        args.output +
        ": the paint on the body was left out, because the format has none; .glb has it");
  }
  if (console.failed()) return;
  write_outputs(args, format, inflated->solid, front, console);
}

}  // namespace

void add_inflate_command(CLI::App& app, Console& console) {
  CLI::App* command = app.add_subcommand("inflate", "Make a solid of the outlines of a sketch");
  const auto args = std::make_shared<InflateArguments>();
  add_options(*command, *args);
  command->footer(
      examples("feltline inflate cat.felt -o cat.stl\n"
               "feltline inflate cat.svg -o cat.glb --png cat.png --film cat.webm\n"
               "feltline inflate ring.ndjson -o ring.3mf --triangles 20000 --thickness 0.5"));
  command->callback([args, &console] { run_inflate(*args, console); });
}

}  // namespace felt::cli
