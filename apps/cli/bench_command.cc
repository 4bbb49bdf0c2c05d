#include <fmt/core.h>

#include <memory>

#include "commands.h"
#include "felt/devices/simulated/samples/sample_sets.h"
#include "felt/io/ndjson/ndjson_parser.h"
#include "fit_source.h"
#include "fit_worker.h"
#include "print.h"

namespace felt::cli {
namespace {

struct BenchArguments {
  std::vector<std::string> inputs;
  double mm_per_unit = 1.0;
  std::vector<double> tolerances_mm = {0.05, 0.15, 0.5};
};

using Strokes = std::vector<std::vector<InkSample>>;

/// Returns strokes that a simulated hand drew.
Strokes simulated_strokes() {
  Strokes strokes;
  for (const SampleSet& set : make_sample_sets()) {
    for (const RecordedStroke& stroke : set.strokes) {
      std::vector<InkSample>& samples = strokes.emplace_back();
      for (const HandSample& s : stroke.samples) {
        samples.push_back({s.position, s.pressure, s.time_ns});
      }
    }
  }
  return strokes;
}

Strokes read_bench_strokes(const BenchArguments& args, Console& console) {
  Strokes strokes;
  FitSettings settings;
  settings.measure = true;
  FitSource source(args.inputs, settings);
  FitItem item;
  NdjsonParser parser;
  RawStroke raw;
  while (source.next(item)) {
    for (std::size_t i = 0; i < item.lines.size(); ++i) {
      const NdjsonLine line = item.lines.line(i);
      const Result<NdjsonKind> kind = parser.raw_stroke(line, raw);
      if (!kind) {
        console.error(fmt::format("{}:{}: {}", item.name, line.number(), kind.error().message));
      } else if (*kind == NdjsonKind::kStroke) {
        for (InkSample& sample : raw.samples) {
          sample.position.x *= args.mm_per_unit;
          sample.position.y *= args.mm_per_unit;
        }
        strokes.push_back(raw.samples);
      }
    }
    if (item.failure) console.error(item.name + ": " + item.failure->message);
  }
  return strokes;
}

FitStats measure(const Strokes& strokes, double tolerance_mm, bool refine) {
  FitSettings settings;
  settings.ink.curve.tolerance_mm = tolerance_mm;
  settings.refine = refine;
  settings.measure = true;
  FitWorker worker(settings);
  FitStats stats;
  for (const std::vector<InkSample>& samples : strokes) worker.fit(samples, stats);
  return stats;
}

void print_row(double tolerance_mm, const char* what, const FitStats& stats) {
  print("{:>9g}  {:8} {:>8} {:>9} {:>9} {:>8} {:>11.6f} {:>10.1f} {:>8} {:>8} {:>10.1f} {:>9g}\n",
        tolerance_mm, what, stats.strokes, stats.samples, stats.segments, stats.corners,
        stats.max_error_mm, per(static_cast<double>(stats.fit_ns), stats.samples),
        stats.calls.quantile(0.999), stats.calls.max(),
        per(static_cast<double>(stats.refine_ns), stats.samples),
        per(static_cast<double>(stats.allocations), stats.samples));
}

void run_bench(const BenchArguments& args, Console& console) {
  const Strokes strokes =
      args.inputs.empty() ? simulated_strokes() : read_bench_strokes(args, console);
  if (strokes.empty()) return;
  print("{:>9}  {:8} {:>8} {:>9} {:>9} {:>8} {:>11} {:>10} {:>8} {:>8} {:>10} {:>9}\n", "tolerance",
        "curve", "strokes", "samples", "segments", "corners", "max error", "ns/sample", "p99.9",
        "max", "refine", "allocs");
  for (const double tolerance_mm : args.tolerances_mm) {
    print_row(tolerance_mm, "online", measure(strokes, tolerance_mm, false));
    print_row(tolerance_mm, "refined", measure(strokes, tolerance_mm, true));
  }
  print(
      "Lengths in mm. Thread CPU time: ns/sample from pen-down to pen-up, p99.9 and max of "
      "single calls,\nrefine per sample at pen-up. Allocations per sample once warm.\n");
}

}  // namespace

void add_bench_command(CLI::App& app, Console& console) {
  CLI::App* command = app.add_subcommand("bench", "Measure how fast this computer fits strokes");
  const auto args = std::make_shared<BenchArguments>();
  command->add_option("IN", args->inputs, "Raw pen strokes, .ndjson (default: simulated ones)");
  command->add_option("--tolerance", args->tolerances_mm, "Tolerances to try, in mm")
      ->check(number_between(0.0, 1e9))
      ->delimiter(',')
      ->capture_default_str();
  command->add_option("--mm-per-unit", args->mm_per_unit, "Size of one unit of the input, in mm")
      ->check(number_between(1e-9, 1e9))
      ->capture_default_str();
  command->footer(
      examples("feltline bench\n"
               "feltline bench strokes.ndjson --tolerance 0.5,1,2"));
  command->callback([args, &console] { run_bench(*args, console); });
}

}  // namespace felt::cli
