#include <fmt/core.h>

#include <memory>
#include <optional>

#include "commands.h"
#include "felt/io/ndjson_parser.h"
#include "file_summary.h"
#include "input.h"
#include "stored_sketch.h"

namespace felt::cli {
namespace {

constexpr std::size_t kBatchBytes = std::size_t{64} << 10;

struct InfoArguments {
  std::string input;
  bool json = false;
};

/// Adds up the records of a file of either kind; the first record decides which one it is.
class Summarizer {
 public:
  Result<void> add(const NdjsonLine& line) {
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
    const Result<Stroke> stroke = Stroke::create(std::move(record_.data));
    if (!stroke) return tl::unexpected(stroke.error());
    summary_.add(*stroke);
    return {};
  }

  void add(const Stroke& stroke) { summary_.add(stroke); }

  [[nodiscard]] const FileSummary& summary() const { return summary_; }

 private:
  NdjsonParser parser_;
  RawStroke raw_;
  SketchRecord record_;
  std::optional<bool> is_sketch_;
  FileSummary summary_;
};

/// The same of a file that is read as a whole.
bool summarize_stored(const std::string& path, Console& console, Summarizer& summarizer) {
  const Result<Sketch> sketch = read_stored_sketch(path);
  if (!sketch) {
    console.error(sketch.error().message);
    return false;
  }
  if (sketch->empty()) console.error(path + ": holds no strokes");
  for (const SketchStroke& stroke : *sketch) summarizer.add(stroke.stroke);
  return true;
}

/// False when nothing could be read.
bool summarize(const std::string& path, Console& console, Summarizer& summarizer) {
  if (is_stored_sketch(path)) return summarize_stored(path, console, summarizer);
  const Result<Input> input = Input::open(path);
  if (!input) {
    console.error(input_name(path) + ": " + input.error().message);
    return false;
  }
  LineReader reader(input->reader());
  LineBatch batch;
  for (;;) {
    const Result<bool> more = reader.fill(batch, kBatchBytes);
    if (!more) console.error(input->name() + ": " + more.error().message);
    if (!more || !*more) break;
    for (std::size_t i = 0; i < batch.size(); ++i) {
      const NdjsonLine line = batch.line(i);
      const Result<void> added = summarizer.add(line);
      if (added) continue;
      console.error(fmt::format("{}:{}: {}", input->name(), line.number(), added.error().message));
    }
    console.progress("reading", reader.bytes_read(), input->size_bytes(),
                     summarizer.summary().strokes);
  }
  console.end_progress();
  if (summarizer.summary().strokes == 0 && !console.failed()) {
    console.error(input->name() + ": holds no strokes");
  }
  return true;
}

}  // namespace

void add_info_command(CLI::App& app, Console& console) {
  CLI::App* command = app.add_subcommand("info", "Say what is in a file");
  const auto args = std::make_shared<InfoArguments>();
  command
      ->add_option("DOC", args->input,
                   "A drawing, sketch or raw pen strokes: .felt, .svg, .ndjson; '-' is stdin")
      ->required();
  command->add_flag("--json", args->json, "One line of JSON");
  command->footer(
      examples("feltline info sketch.ndjson\n"
               "feltline info strokes.ndjson --json"));
  command->callback([args, &console] {
    Summarizer summarizer;
    if (!summarize(args->input, console, summarizer)) return;
    const FileSummary& summary = summarizer.summary();
    fmt::print("{}", args->json ? summary_json(summary) : summary_text(summary));
  });
}

}  // namespace felt::cli
