#include <memory>

#include "commands.h"
#include "felt/store/felt_file.h"
#include "sketch_input.h"
#include "sketch_output.h"

namespace felt::cli {
namespace {

/// The command line as written. `render` and `convert` are the same work; the first makes pictures
/// only and shows its options accordingly.
struct ConvertArguments {
  std::string input;
  std::string output;
  std::string to;
  PictureArguments picture;
};

void add_options(CLI::App& command, ConvertArguments& args, const char* output_help) {
  command
      .add_option("IN", args.input, "The sketch: .ndjson, .felt, .svg of Feltline; '-' is stdin")
      ->required();
  command.add_option("-o,--output", args.output, output_help)->required();
  command.add_option("--to", args.to, "Format of the output, instead of by its extension");
  args.picture.add_to(command);
}

/// From .felt to .felt nothing is lost: layers, sheet and ids come along.
void copy_felt(const ConvertArguments& args, Console& console) {
  const Result<void> done = read_felt(args.input).and_then([&](const StoredDrawing& d) {
    return write_felt(args.output, d);
  });
  if (!done) console.error(done.error().message);
}

void convert(const ConvertArguments& args, Format format, Console& console) {
  if (format == Format::kFelt && format_of_path(args.input).value_or(format) == format &&
      args.input != "-") {
    return copy_felt(args, console);
  }
  const Result<PictureOptions> picture = args.picture.parse();
  if (!picture) throw UsageError(picture.error().message);
  Result<std::unique_ptr<SketchOutput>> output = open_sketch_output(args.output, format, *picture);
  if (!output) return console.error(output.error().message);
  bool empty = true;
  const bool read = for_each_piece(args.input, format, console, [&](const SketchPiece& piece) {
    empty = false;
    const Result<void> appended = (*output)->append(piece);
    if (!appended) console.error(appended.error().message);
    return appended.has_value();
  });
  // A good older file is worth more than an empty new one.
  if (!read || (empty && console.failed())) return;
  if (Result<void> done = (*output)->finish(); !done) console.error(done.error().message);
}

Format wanted_format(const ConvertArguments& args) {
  const Result<Format> format = output_format(args.output, args.to);
  if (!format) throw UsageError(format.error().message);
  return *format;
}

}  // namespace

void add_render_command(CLI::App& app, Console& console) {
  CLI::App* command = app.add_subcommand("render", "Make a picture of a sketch");
  const auto args = std::make_shared<ConvertArguments>();
  add_options(*command, *args,
              "Where the picture goes: .png, .svg or .pdf; '-' is stdout (with --to)");
  command->footer(
      examples("feltline render sketch.ndjson -o page.png --page A4 --dpi 300\n"
               "feltline render sketch.ndjson -o ink.png --paper transparent\n"
               "feltline render - -o - --to svg < sketch.ndjson"));
  command->callback([args, &console] {
    const Format format = wanted_format(*args);
    if (format == Format::kNdjson || format == Format::kFelt) {
      throw UsageError("render makes .png, .svg or .pdf; see convert");
    }
    convert(*args, format, console);
  });
}

void add_convert_command(CLI::App& app, Console& console) {
  CLI::App* command = app.add_subcommand("convert", "Write a sketch in another format");
  const auto args = std::make_shared<ConvertArguments>();
  add_options(*command, *args, "Where it goes: .ndjson, .felt, .svg, .pdf or .png; '-' is stdout");
  command->footer(
      examples("feltline convert sketch.ndjson -o sketch.svg\n"
               "feltline convert sketch.ndjson -o - | wc -l"));
  command->callback([args, &console] { convert(*args, wanted_format(*args), console); });
}

}  // namespace felt::cli
