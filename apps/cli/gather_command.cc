#include <fmt/core.h>

#include <algorithm>
#include <memory>
#include <vector>

#include "commands.h"
#include "drawing_output.h"
#include "felt/base/csv_value.h"
#include "felt/formats/format_traits.h"
#include "gather_drawing.h"
#include "input.h"
#include "overwrite_check.h"
#include "sketch_input.h"

namespace felt::cli {
namespace {

/// The options and arguments of the command line.
struct GatherArguments {
  std::string input;
  std::string output;
  std::string to;
  std::string groups;
  std::string width = "median";
  bool all = false;
  PictureArguments picture;
};

void add_options(CLI::App& command, GatherArguments& args) {
  command
      .add_option("IN", args.input,
                  "A sketch, or raw pen strokes ('-' is stdin). Its format is detected from its "
                  "content: " +
                      readable_names())
      ->required();
  command
      .add_flag("--all", args.all,
                "Gather the strokes of all layers that are visible and not locked, layer by layer")
      ->required();
  command
      .add_option("-o,--output", args.output,
                  "Output file ('-' is stdout). Formats: " + writable_names())
      ->required();
  command.add_option("--to", args.to, "Output format; the default is set by the file extension");
  command.add_option("--groups", args.groups,
                     "Also write the group of each stroke, as .csv with the columns stroke and "
                     "group");
  command
      .add_option("--width", args.width,
                  "Width of a gathered line: the median of its strokes, or that of the strip")
      ->check(CLI::IsMember({"median", "strip"}))
      ->capture_default_str();
  args.picture.add_to(command);
}

void write_groups(const std::vector<StrokeGroup>& groups, const std::string& path,
                  Console& console) {
  std::string text = "stroke,group\n";
  for (const StrokeGroup& entry : groups) {
    append_csv_value(text, entry.stroke);
    text += fmt::format(",{}\n", entry.group);
  }
  const Result<void> done =
      Output::create(path).and_then([&](Output output) { return output.write_all(text); });
  if (!done) console.error(done.error().message);
}

void run_gather(const GatherArguments& args, Console& console) {
  if (args.output == "-" && args.groups == "-") {
    throw UsageError("-o - and --groups - cannot both use stdout");
  }
  check_no_overwrite({args.input}, {{"-o", args.output}, {"--groups", args.groups}}, console);
  const Result<Format> format = output_format(args.output, args.to);
  if (!format) throw UsageError(format.error().message);
  const Result<PictureOptions> picture = args.picture.parse(console);
  if (!picture) throw UsageError(picture.error());
  const Result<Input> input = Input::open(args.input);
  if (!input) return console.error(input_name(args.input) + ": " + input.error().message);
  Result<Imported> opened = input->read_drawing({});
  if (!opened) return console.error(input->name() + ": " + opened.error().message);
  if (!report_notices(input->name(), opened->report, console)) return;
  if (opened->drawing.document.stroke_count() == 0) {
    return console.error(input->name() + ": contains no strokes");
  }
  const GatheredWidth width =
      args.width == "strip" ? GatheredWidth::kStrip : GatheredWidth::kMedian;
  const Result<GatheredDrawing> gathered = gather_drawing(opened->drawing, {.width = width});
  if (!gathered) return console.error(input->name() + ": " + gathered.error().message);
  if (gathered->left_alone > 0) {
    console.notice(fmt::format("{}: left {} strokes of locked or hidden layers as they are",
                               input->name(), gathered->left_alone));
  }
  const std::size_t strokes = gathered->groups.size();
  std::uint32_t lines = 0;
  for (const StrokeGroup& entry : gathered->groups) lines = std::max(lines, entry.group);
  console.summary(fmt::format("{}: {} stroke{} became {} line{}", input->name(), strokes,
                              strokes == 1 ? "" : "s", lines, lines == 1 ? "" : "s"));
  const Result<void> done =
      DrawingOutput::create(args.output, *format, *picture).and_then([&](DrawingOutput output) {
        return output.write(std::move(opened->drawing));
      });
  if (!done) return console.error(done.error().message);
  if (!args.groups.empty()) write_groups(gathered->groups, args.groups, console);
}

}  // namespace

void add_gather_command(CLI::App& app, Console& console) {
  CLI::App* command =
      app.add_subcommand("gather", "Press each bundle of rough strokes into one line");
  const auto args = std::make_shared<GatherArguments>();
  add_options(*command, *args);
  command->footer(
      examples("feltline gather --all rough.ndjson -o clean.svg\n"
               "feltline gather --all rough.felt -o clean.felt --groups groups.csv\n"
               "feltline gather --all rough.svg -o clean.svg --width strip"));
  command->callback([args, &console] { run_gather(*args, console); });
}

}  // namespace felt::cli
