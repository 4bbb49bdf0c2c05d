#include <fmt/core.h>

#include <memory>
#include <vector>

#include "commands.h"
#include "felt/base/read_file.h"
#include "felt/io/events/event_reader.h"
#include "felt/stroke/steady/shake_finder.h"
#include "input.h"
#include "output.h"
#include "overwrite_check.h"
#include "print.h"
#include "steady_file.h"

namespace felt::cli {
namespace {

/// The options and arguments of the command line.
struct CalibrateArguments {
  std::string input;
  std::string output;
};

/// Returns the samples of strokes, or those of a recording while the pen touches.
Result<std::vector<InkSample>> samples_of(const std::string& path) {
  const Result<std::string> bytes = read_file(path, kMaxSpiralBytes);
  if (!bytes) return tl::unexpected(bytes.error());
  std::vector<InkSample> samples;
  ScriptSink sink;
  sink.stroke = [&samples](const RawStroke& stroke) -> Result<void> {
    samples.insert(samples.end(), stroke.samples.begin(), stroke.samples.end());
    return {};
  };
  sink.event = [&samples](const Event& event) -> Result<void> {
    const auto* pen = std::get_if<PenEvent>(&event.what);
    if (!pen) return {};
    const PenSample sample = sample_of(event.time_ns, *pen);
    if (in_contact(sample)) {
      samples.push_back({on_page(sample.position), sample.pressure, sample.time_ns});
    }
    return {};
  };
  if (Result<void> read = read_script(input_name(path), read_text(*bytes), sink); !read) {
    return tl::unexpected(read.error());
  }
  return samples;
}

void run_calibrate(const CalibrateArguments& args, Console& console) {
  check_no_overwrite({args.input}, {{"-o", args.output}}, console);
  const Result<std::vector<InkSample>> samples = samples_of(args.input);
  if (!samples) return console.error(samples.error().message);
  const Result<Shake> shake = find_shake(*samples);
  if (!shake) return console.error(input_name(args.input) + ": " + shake.error().message);
  const Result<void> done = Output::create(args.output).and_then([&](Output output) {
    return output.write_all(write_shake(*shake));
  });
  if (!done) return console.error(done.error().message);
  console.notice(
      fmt::format("This hand shakes {:.1f} times a second, by {:.1f} mm to each side, along {:.0f} "
                  "degrees. Use it with --steady.",
                  shake->hz, shake->amplitude_mm, shake->axis_deg));
}

}  // namespace

void add_steady_command(CLI::App& app, Console& console) {
  CLI::App* command =
      app.add_subcommand("steady", "Measure how a hand shakes, for lines without the shaking");
  command->require_subcommand(1);
  CLI::App* calibrate = command->add_subcommand(
      "calibrate", "Find frequency, amplitude and axis of the shaking from a spiral of 10 s");
  const auto args = std::make_shared<CalibrateArguments>();
  args->output = "-";
  calibrate
      ->add_option("IN", args->input,
                   "A slowly drawn spiral: raw pen strokes with times (.ndjson), or a recording; "
                   "'-' is stdin")
      ->required();
  calibrate->add_option("-o,--output", args->output, "File to write ('-' is stdout)")
      ->capture_default_str();
  calibrate->footer(
      examples("feltline steady calibrate spiral.ndjson -o my-hand.steady\n"
               "feltline fit strokes.ndjson --steady my-hand.steady -o sketch.svg"));
  calibrate->callback([args, &console] { run_calibrate(*args, console); });
}

}  // namespace felt::cli
