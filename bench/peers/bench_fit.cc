/// Compares curve fitters in one run, with the same strokes and the same checker. README.md in this
/// folder describes each row.

#include <CLI/CLI.hpp>
#include <cinttypes>
#include <cstdio>
#include <exception>

#include "bench/peers/long_report.h"
#include "bench/peers/table.h"

namespace felt::bench {
namespace {

struct Arguments {
  std::vector<std::string> data;
  double mm_per_unit = 1.0;
  std::vector<double> tolerances{0.5, 1.0, 2.0};
  int repeats = 3;
  std::string only;  ///< run only fitters with this text in their name
  NpmFolders npm;
  bool by_source = false;
  std::string csv;
  std::int64_t long_samples = 0;
  unsigned seed = 1;
};

bool wanted(const Arguments& arguments, const std::string& name) {
  return name.find(arguments.only) != std::string::npos;
}

std::vector<Row> rows_at(const Arguments& arguments, const InkData& data, double tolerance) {
  std::vector<Row> rows;
  const auto run = [&](const Peers& peers) {
    for (const auto& peer : peers) {
      if (!wanted(arguments, peer->name())) continue;
      std::fprintf(stderr, "tolerance %g: %s\n", tolerance, peer->name().c_str());
      rows.push_back(measure(*peer, data, tolerance, arguments.repeats));
    }
  };
  run(make_lib2geom_peers(tolerance));
  for (const char* package : {"fit-curve", "paper", "feltline"}) {
    if (!wanted(arguments, package)) continue;
    std::fprintf(stderr, "tolerance %g: %s\n", tolerance, package);
    rows.push_back(measure_npm(package, data, tolerance, arguments.repeats, arguments.npm));
  }
  run(make_feltline_peers(tolerance));
  return rows;
}

void print_head(const InkData& data, int repeats) {
  std::printf("Data: %s: %zu strokes, %" PRId64
              " samples; deduplicated for peers %zu strokes, "
              "%" PRId64 " samples.\n",
              data.name.c_str(), data.raw.size(), sample_count(data.raw), data.deduplicated.size(),
              sample_count(data.deduplicated));
  std::printf("CPU time, least of %d runs; a single call's includes %" PRId64
              " ns for reading the clock.\n",
              repeats, timer_overhead_ns());
}

void compare(const Arguments& arguments) {
  const InkData data = read_ink_data(arguments.data, arguments.mm_per_unit);
  print_head(data, arguments.repeats);
  std::vector<Row> all;
  for (const double tolerance : arguments.tolerances) {
    const std::vector<Row> rows = rows_at(arguments, data, tolerance);
    std::printf("\n## Tolerance %g\n\n", tolerance);
    print_table(stdout, rows);
    if (arguments.by_source) print_sources(stdout, rows);
    std::fflush(stdout);
    all.insert(all.end(), rows.begin(), rows.end());
  }
  if (!arguments.csv.empty()) write_csv(arguments.csv, all);
}

void describe(CLI::App& app, Arguments& arguments) {
  app.add_option("--data", arguments.data, "raw strokes (.ndjson), one or more files");
  app.add_option("--mm-per-unit", arguments.mm_per_unit, "millimetres per unit of the data (1)")
      ->check(CLI::PositiveNumber);
  app.add_option("--tolerance", arguments.tolerances, "millimetres (0.5 1 2)")
      ->check(CLI::PositiveNumber);
  app.add_option("--repeats", arguments.repeats, "timed runs of each (3)")
      ->check(CLI::Range(1, 99));
  app.add_option("--only", arguments.only, "fitters with this in their name");
  app.add_option("--npm-dir", arguments.npm.modules, "folder that contains node_modules");
  app.add_option("--scratch", arguments.npm.scratch,
                 "folder for files that are exchanged with node");
  app.add_flag("--by-source", arguments.by_source, "one table per source as well");
  app.add_option("--csv", arguments.csv, "write all rows to this file");
  app.add_option("--long", arguments.long_samples,
                 "instead, measure single calls on one stroke of N generated samples")
      ->check(CLI::PositiveNumber);
  app.add_option("--seed", arguments.seed, "of --long (1)");
}

int run(const Arguments& arguments) {
  if (arguments.long_samples > 0) {
    for (const double tolerance : arguments.tolerances) {
      print_long_report(arguments.long_samples, tolerance, arguments.repeats, arguments.seed,
                        arguments.only);
    }
    return 0;
  }
  if (arguments.data.empty()) {
    std::fprintf(stderr, "bench_fit: --data or --long is needed\n");
    return 2;
  }
  compare(arguments);
  return 0;
}

int parse_and_run(int argc, char** argv) {
  Arguments arguments;
  CLI::App app("Curve fitters side by side.", "bench_fit");
  describe(app, arguments);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;  // 0 means that --help was given
  }
  return run(arguments);
}

}  // namespace
}  // namespace felt::bench

int main(int argc, char** argv) {
  try {
    return felt::bench::parse_and_run(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "bench_fit: %s\n", error.what());
    return 1;
  }
}
