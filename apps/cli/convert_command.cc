#include <memory>

#include "commands.h"
#include "convert_drawing.h"
#include "drawing_output.h"
#include "felt/formats/file_format.h"
#include "felt/formats/format_traits.h"
#include "felt/formats/joined_pieces.h"
#include "felt/formats/lost_objects.h"
#include "input.h"
#include "overwrite_check.h"
#include "sketch_input.h"
#include "swell_output.h"

namespace felt::cli {
namespace {

/// The options and arguments of the command line. `render` and `convert` do the same work, but
/// `render` only makes pictures, and its help shows only the options for pictures.
struct ConvertArguments {
  std::string input;
  std::string output;
  std::string to;
  std::string layers;
  bool salvage = false;
  bool join = false;
  bool compact = false;
  bool pictures = false;
  bool swell = false;
  PictureArguments picture;
};

void add_options(CLI::App& command, ConvertArguments& args, const char* output_help) {
  command
      .add_option("IN", args.input,
                  "The drawing ('-' is stdin). Its format is detected from its content: " +
                      readable_names())
      ->required();
  command.add_option("-o,--output", args.output, output_help)->required();
  command.add_option("--to", args.to, "Output format; the default is set by the file extension");
  command
      .add_option("--layers", args.layers,
                  "Include only these layers, and show them: 'visible', 'all', numbers as\n"
                  "printed by info ('1,3'), or the name of a layer. Default: all layers; hidden\n"
                  "layers stay hidden")
      ->check(not_empty());
  command.add_flag("--salvage", args.salvage,
                   "Recover the readable parts of a damaged .felt, and report what is missing");
  command.add_flag("--join", args.join,
                   "Join lines of one colour that follow each other end on start: many programs\n"
                   "write a stroke of changing width as short lines");
  command
      .add_flag("--compact", args.compact,
                "Make a small .svg for web pages: only the visible ink, as outlines rounded to\n"
                "0.01 mm, without layers and without the data with which Feltline and Inkscape\n"
                "edit the lines")
      ->group("Pictures (.svg, .pdf, .png)");
  command
      .add_flag(
          "--pictures", args.pictures,
          "Show the pictures below visible layers in a .png, .svg or .pdf. Default: only those\n"
          "that are marked for export")
      ->group("Pictures (.svg, .pdf, .png)");
  command
      .add_flag(
          "--swell", args.swell,
          "Make an .svg or .pdf for swell paper: black at true size, lines at least 1 mm wide\n"
          "in at most five widths, areas as textures, no grain and no pictures. Prints what\n"
          "was changed")
      ->group("Pictures (.svg, .pdf, .png)");
  args.picture.add_to(command);
  args.picture.add_grain_to(command);
}

/// Converts lines one by one, so that they do not have to be in memory together.
void convert_lines(const Input& input, const ConvertArguments& args, Format format,
                   const PictureOptions& picture, Console& console) {
  if (!args.layers.empty() && args.layers != "all" && args.layers != "visible") {
    return console.error(input.name() + ": .ndjson has no layers to choose from");
  }
  Result<DrawingOutput> output =
      DrawingOutput::create(args.output, format, picture, OutputUse::kStrokes);
  if (!output) return console.error(output.error().message);
  bool empty = true;
  const bool read = for_each_piece(input, format, console, [&](const EncodedStrokes& piece) {
    empty = false;
    const Result<void> appended = output->append(piece);
    if (!appended) console.error(appended.error().message);
    return appended.has_value();
  });
  // If nothing could be read, keeps an existing output file instead of replacing it by an empty
  // one.
  if (!read || (empty && console.failed())) return;
  if (Result<void> done = output->finish(); !done) return console.error(done.error().message);
  note_losses(args.output, output->lost(), console);
}

/// Joins the pieces of strokes if the user wants that, and prints how many there were.
Result<void> join_lines(Drawing& drawing, const ConvertArguments& args, Console& console) {
  if (!args.join) return {};
  const std::size_t before = drawing.document.stroke_count();
  const Result<std::size_t> joined = join_pieces(drawing);
  if (!joined) return tl::unexpected(joined.error());
  const std::size_t strokes = *joined - (before - drawing.document.stroke_count());
  console.notice(args.output + ": " + std::to_string(*joined) + " lines became " +
                 std::to_string(strokes) + (strokes == 1 ? " stroke" : " strokes"));
  return {};
}

void convert_whole(const Input& input, const ConvertArguments& args, Format format,
                   PictureOptions picture, Console& console) {
  Result<Imported> opened = input.read_drawing({.salvage = args.salvage});
  if (!opened) return console.error(input.name() + ": " + opened.error().message);
  if (!report_notices(input.name(), opened->report, console)) return;
  // A drawing written by Feltline may be empty. For other files, keeps an older output instead of
  // replacing it by an empty file.
  if (is_blank(opened->drawing.document) && !opened->is_exact) {
    return console.error(input.name() + ": contains no strokes");
  }
  const Result<void> done =
      choose_layers(args.layers, opened->drawing)
          .and_then([&]() -> Result<void> { return join_lines(opened->drawing, args, console); })
          .and_then([&]() -> Result<void> {
            if (!args.swell) return {};
            return make_swell_drawing(opened->drawing, picture, args.output, console);
          })
          .and_then([&] { return DrawingOutput::create(args.output, format, picture); })
          .and_then([&](DrawingOutput output) {
            note_losses(args.output, lost_objects(opened->drawing, format, args.compact), console,
                        "; --layers all includes them");
            return output.write(std::move(opened->drawing));
          });
  if (!done) console.error(done.error().message);
}

void check_swell_arguments(const ConvertArguments& args, Format format) {
  if (format != Format::kSvg && format != Format::kPdf) {
    throw UsageError("--swell is only for .svg and .pdf");
  }
  const bool has_look = args.picture.grain || args.pictures || !args.picture.surface.empty();
  if (has_look || !args.picture.paper.empty()) {
    throw UsageError("--swell excludes --grain, --pictures, --surface and --paper");
  }
}

void convert(const ConvertArguments& args, Format format, Console& console) {
  check_no_overwrite({args.input}, {{"-o", args.output}}, console);
  Result<PictureOptions> picture = args.picture.parse(console);
  if (!picture) throw UsageError(picture.error());
  if (args.compact && format != Format::kSvg) throw UsageError("--compact is only for .svg");
  if (args.compact && args.picture.grain) throw UsageError("--compact excludes --grain");
  if (args.pictures && (args.compact || !traits_of(format).picture)) {
    throw UsageError("--pictures is only for .png, .pdf, and .svg without --compact");
  }
  if (args.swell) check_swell_arguments(args, format);
  picture->compact = args.compact || (args.swell && format == Format::kSvg);
  if (args.pictures) picture->pictures = PictureChoice::kAll;
  const Result<Input> input = Input::open(args.input);
  if (!input) return console.error(input_name(args.input) + ": " + input.error().message);
  // Compressed output, compact output, and output that shows the drawing's surface, cannot be
  // written stroke by stroke.
  const bool is_stream = input->is_lines() && !is_compressed_name(args.output) &&
                         !picture->wants_grain && !args.compact && !args.swell && !args.join;
  if (is_stream) return convert_lines(*input, args, format, *picture, console);
  convert_whole(*input, args, format, *picture, console);
}

Format wanted_format(const ConvertArguments& args) {
  const Result<Format> format = output_format(args.output, args.to);
  if (!format) throw UsageError(format.error().message);
  return *format;
}

}  // namespace

void add_render_command(CLI::App& app, Console& console) {
  CLI::App* command = app.add_subcommand("render", "Render a sketch as a picture");
  const auto args = std::make_shared<ConvertArguments>();
  add_options(*command, *args, "Output file: .png, .svg or .pdf; '-' is stdout (with --to)");
  command->footer(
      examples("feltline render sketch.ndjson -o page.png --page A4 --dpi 300\n"
               "feltline render sketch.ndjson -o ink.png --paper transparent\n"
               "feltline render drawing.felt -o drawing.pdf --grain\n"
               "feltline render - -o - --to svg < sketch.ndjson"));
  command->callback([args, &console] {
    const Format format = wanted_format(*args);
    if (!traits_of(format).picture) {
      throw UsageError("render makes .png, .svg or .pdf; see convert");
    }
    convert(*args, format, console);
  });
}

void add_convert_command(CLI::App& app, Console& console) {
  CLI::App* command = app.add_subcommand("convert", "Write a sketch in another format");
  const auto args = std::make_shared<ConvertArguments>();
  const std::string where = "Output file ('-' is stdout). Formats: " + writable_names();
  add_options(*command, *args, where.c_str());
  command->footer(
      examples("feltline convert sketch.ndjson -o sketch.svg\n"
               "feltline convert drawing.felt -o drawing.svg --layers visible\n"
               "feltline convert drawing.felt -o web.svg --compact\n"
               "feltline convert map.felt -o map.pdf --swell\n"
               "feltline convert sketch.ndjson -o - | wc -l"));
  command->callback([args, &console] { convert(*args, wanted_format(*args), console); });
}

}  // namespace felt::cli
