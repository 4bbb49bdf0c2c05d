/// fit_check RAW.ndjson SKETCH.ndjson checks a file of fitted strokes against the raw ink. Exits
/// with 0 if every guarantee holds, 1 if one is broken or the input is unreadable, and 2 if the
/// command line is wrong.

#include <CLI/CLI.hpp>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <stdexcept>

#include "tests/support/fit_files.h"

namespace fit_check {
namespace {

void print_corners(const Report& r) {
  std::printf("corners declared     %d\n", r.corners);
  if (r.corners == 0) return;
  for (std::size_t arm = 0; arm < kArmInTolerances.size(); ++arm) {
    std::printf("  ink turn, arm %g tol:", kArmInTolerances[arm]);
    for (std::size_t k = 0; k < kCornerDeg.size(); ++k) {
      std::printf("  %d under %g deg", r.weak_corners[arm][k], kCornerDeg[k]);
    }
    std::printf("\n");
  }
  std::printf("  within 2 tol of an end %d, curve bends under 5 deg %d\n", r.corners_near_end,
              r.corners_bend_less);
}

void print_report(const Report& r) {
  std::printf("strokes              %d (%d missing, %d invalid)\n", r.strokes, r.missing,
              r.invalid);
  std::printf("samples              %lld\n", static_cast<long long>(r.samples));
  std::printf("segments             %lld (%d degenerate)\n", static_cast<long long>(r.segments),
              r.degenerate_segments);
  std::printf("over tolerance       %d strokes\n", r.over_tolerance);
  std::printf("error                mean %.4f  max %.9f in %s\n", r.mean_error(), r.max_error,
              r.worst_id.c_str());
  std::printf("G1 breaks            %d over 1e-3 deg, %d over 5, %d over 30; largest %.3g in %s\n",
              r.breaks[0], r.breaks[1], r.breaks[2], r.max_smooth_turn_deg,
              r.most_broken_id.c_str());
  std::printf("kinks                %d (60 deg within 0.25 tol of arc, not declared)\n", r.kinks);
  std::printf("joint gap            %.3g\n", r.max_gap);
  std::printf("overshoot            p99 %.3f  max %.3f in %s\n", r.overshoot_quantile(0.99),
              r.max_overshoot(), r.overshoot_id.c_str());
  std::printf("  less 4 tol and gap %d strokes above; largest %.3f in %s\n", r.overshoot_violations,
              r.overshoot_excess, r.excess_id.c_str());
  print_corners(r);
  std::printf("verdict              %s\n", r.clean() ? "clean" : "NOT clean");
}

void print_sources(const std::map<std::string, Report>& sources) {
  std::printf("\n%-40s %7s %8s %8s %5s %7s %7s %6s %6s %7s %7s\n", "source", "strokes", "samples",
              "segments", "over", "max", "mean", "G1>1e-3", "kinks", "corners", "o.max");
  for (const auto& [source, r] : sources) {
    std::printf("%-40s %7d %8lld %8lld %5d %7.4f %7.4f %6d %6d %7d %7.2f\n", source.c_str(),
                r.strokes, static_cast<long long>(r.samples), static_cast<long long>(r.segments),
                r.over_tolerance, r.max_error, r.mean_error(), r.breaks[0], r.kinks, r.corners,
                r.max_overshoot());
  }
}

void list_bad_strokes(const std::vector<Ink>& inks, const std::vector<FitCurve>& curves,
                      double tolerance) {
  for (const Ink& ink : inks) {
    for (const FitCurve& curve : curves) {
      if (curve.id != ink.id) continue;
      const Report r = check_stroke(ink, curve, tolerance);
      if (r.clean() && r.kinks == 0) continue;
      std::printf("%s: error %.6f, breaks %d/%d/%d, kinks %d, overshoot %.3f (excess %.3f)\n",
                  ink.id.c_str(), r.max_error, r.breaks[0], r.breaks[1], r.breaks[2], r.kinks,
                  r.max_overshoot(), r.overshoot_excess);
      break;
    }
  }
}

std::ifstream open(const std::string& path) {
  std::ifstream in(path);
  if (!in) throw std::runtime_error(path + ": cannot be opened");
  return in;
}

struct Arguments {
  std::string raw, sketch;
  double mm_per_unit = 1.0, tolerance = 1.0;
  bool by_source = false, list = false;
};

int run(const Arguments& arguments) {
  std::ifstream raw = open(arguments.raw), sketch = open(arguments.sketch);
  const std::vector<Ink> inks = read_inks(raw, arguments.mm_per_unit);
  const std::vector<FitCurve> curves = read_curves(sketch);
  std::map<std::string, Report> sources;
  const Report total = check_all(inks, curves, arguments.tolerance, &sources);
  print_report(total);
  if (arguments.by_source) print_sources(sources);
  if (arguments.list) list_bad_strokes(inks, curves, arguments.tolerance);
  return total.clean() ? 0 : 1;
}

int parse_and_run(int argc, char** argv) {
  Arguments arguments;
  CLI::App app("Judges fitted strokes against the raw ink they were made from.", "fit_check");
  app.add_option("RAW", arguments.raw, "raw strokes (.ndjson)")->required();
  app.add_option("SKETCH", arguments.sketch, "fitted strokes (.ndjson)")->required();
  app.add_option("--mm-per-unit", arguments.mm_per_unit, "millimetres per unit of RAW (1)")
      ->check(CLI::PositiveNumber);
  app.add_option("--tolerance", arguments.tolerance, "millimetres (1)")->check(CLI::PositiveNumber);
  app.add_flag("--by-source", arguments.by_source, "one row per source as well");
  app.add_flag("--list", arguments.list, "name every stroke that breaks a guarantee or has a kink");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;  // exit() returns 0 for --help
  }
  return run(arguments);
}

}  // namespace
}  // namespace fit_check

int main(int argc, char** argv) {
  try {
    return fit_check::parse_and_run(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "fit_check: %s\n", error.what());
    return 1;
  }
}
