#include <fmt/core.h>

#include <memory>
#include <optional>

#include "commands.h"
#include "felt/formats/format_traits.h"
#include "felt/io/ndjson/ndjson_parser.h"
#include "felt/io/quickdraw/quickdraw_line.h"
#include "felt/stroke/edit/mend_joints.h"
#include "file_summary.h"
#include "input.h"
#include "print.h"
#include "sketch_input.h"

namespace felt::cli {
namespace {

constexpr std::size_t kInfoBatchBytes = std::size_t{64} << 10;

struct InfoArguments {
  std::string input;
  bool json = false;
};

/// Summarizes the records of a file. The first record determines whether it contains a sketch or
/// raw pen strokes.
class Summarizer {
 public:
  explicit Summarizer(FileSummary& summary) : summary_(summary) {}

  Result<void> add(const NdjsonLine& line) {
    if (looks_like_quickdraw(line.text())) return fail(ErrorCode::kUnsupported, kUnknownQuickdraw);
    if (!is_sketch_) is_sketch_ = line.text().find("\"segments\"") != std::string_view::npos;
    const Result<NdjsonKind> kind =
        *is_sketch_ ? parser_.sketch_stroke(line, record_) : parser_.raw_stroke(line, raw_);
    if (!kind) return tl::unexpected(kind.error());
    if (*kind == NdjsonKind::kHeader) {
      if (summary_.strokes == 0) is_sketch_.reset();
      return {};
    }
    if (!*is_sketch_) {
      summary_.add(raw_);
      return {};
    }
    mend_rounding(record_.data);
    const Result<Stroke> stroke = Stroke::create(std::move(record_.data));
    if (!stroke) return tl::unexpected(stroke.error());
    summary_.add(*stroke);
    return {};
  }

 private:
  NdjsonParser parser_;
  RawStroke raw_;
  SketchRecord record_;
  std::optional<bool> is_sketch_;
  FileSummary& summary_;
};

void summarize_lines(const Input& input, Console& console, FileSummary& summary) {
  LineReader reader(input.reader());
  LineBatch batch;
  Summarizer summarizer(summary);
  for (;;) {
    const Result<bool> more = reader.fill(batch, kInfoBatchBytes);
    if (!more) console.error(input.name() + ": " + more.error().message);
    if (!more || !*more) break;
    for (std::size_t i = 0; i < batch.size(); ++i) {
      const NdjsonLine line = batch.line(i);
      const Result<void> added = summarizer.add(line);
      if (added) continue;
      console.record_error(input.name(), line.number(), added.error().message);
    }
    console.progress("reading", reader.bytes_read(), input.size_bytes(), summary.strokes);
  }
  console.end_progress();
  console.end_records();
  if (summary.strokes == 0 && !console.failed()) {
    console.error(input.name() + ": contains no strokes");
  }
}

/// Summarizes a file that is read as a whole, including strokes of hidden layers.
bool summarize_whole(const Input& input, Console& console, FileSummary& summary) {
  Result<Imported> opened = input.read_drawing({});
  if (!opened) {
    console.error(input.name() + ": " + opened.error().message);
    return false;
  }
  report_notices(input.name(), opened->report, console);
  const Document& document = opened->drawing.document;
  for (const Layer& layer : document.layers()) {
    for (const StrokeId id : layer.strokes) summary.add(*document.find(id));
  }
  summary.is_sketch = true;
  if (is_blank(document) && !opened->is_exact)
    console.error(input.name() + ": contains no strokes");
  summary.opened = *std::move(opened);
  return true;
}

/// Summarizes the file at `path`. Returns false if nothing could be read.
bool summarize(const std::string& path, Console& console, FileSummary& summary) {
  const Result<Input> input = Input::open(path);
  if (!input) {
    console.error(input_name(path) + ": " + input.error().message);
    return false;
  }
  summary.format = input->format();
  if (!input->is_lines()) return summarize_whole(*input, console, summary);
  summarize_lines(*input, console, summary);
  return true;
}

}  // namespace

void add_info_command(CLI::App& app, Console& console) {
  CLI::App* command = app.add_subcommand("info", "Show what a file contains");
  const auto args = std::make_shared<InfoArguments>();
  command
      ->add_option(
          "DOC", args->input,
          "A drawing or raw pen strokes ('-' is stdin). The format is detected from the content: " +
              readable_names())
      ->required();
  command->add_flag("--json", args->json, "One line of JSON");
  command->footer(
      examples("feltline info sketch.ndjson\n"
               "feltline info strokes.ndjson --json"));
  command->callback([args, &console] {
    FileSummary summary;
    if (!summarize(args->input, console, summary)) return;
    print("{}", args->json ? summary_json(summary) : summary_text(summary));
  });
}

}  // namespace felt::cli
