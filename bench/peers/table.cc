#include "bench/peers/table.h"

#include <cinttypes>
#include <set>
#include <stdexcept>

namespace felt::bench {
namespace {

constexpr std::size_t kOver5 = 1;  // index of 5 degrees in fit_check::kBreakDeg

double per_stroke(const fit_check::Report& r) {
  return r.strokes > 0 ? static_cast<double>(r.segments) / r.strokes : 0.0;
}

/// Returns the number of declared corners at which the ink turns by less than 45 degrees, measured
/// with arms of 4 tolerances.
int weak_corners(const fit_check::Report& r) {
  return r.weak_corners[1][0];
}

void print_result(std::FILE* out, const fit_check::Report& r) {
  std::fprintf(out, " %" PRId64 " | %.2f | %.3f | %.3f | %d | %d | %d / %d | %.1f / %.1f / %d |",
               r.segments, per_stroke(r), r.max_error, r.mean_error(), r.over_tolerance,
               r.breaks[kOver5], r.corners, weak_corners(r), r.overshoot_quantile(0.99),
               r.max_overshoot(), r.overshoot_violations);
}

void print_cost(std::FILE* out, const Cost& cost) {
  std::fprintf(out, " %.0f | %.1f / %.1f per %s |", cost.per_sample, cost.call_p999 / 1000.0,
               cost.call_max / 1000.0, cost.call_unit.c_str());
  if (cost.allocations_per_sample) {
    std::fprintf(out, " %.4f |\n", *cost.allocations_per_sample);
  } else {
    std::fprintf(out, " |\n");
  }
}

void write_csv_row(std::FILE* out, const Row& row, const std::string& source,
                   const fit_check::Report& r) {
  std::fprintf(out, "%s,%g,%s,%d,%" PRId64 ",%" PRId64 ",%.6f,%.6f,%d,%d,%d,%d,%.4f,%.4f,%d",
               row.peer.c_str(), row.tolerance, source.c_str(), r.strokes, r.samples, r.segments,
               r.max_error, r.mean_error(), r.over_tolerance, r.breaks[0], r.breaks[kOver5],
               r.corners, r.overshoot_quantile(0.99), r.max_overshoot(), r.overshoot_violations);
  if (source != "all") {
    std::fprintf(out, ",,,,,\n");
    return;
  }
  std::fprintf(out, ",%s,%s,%.1f,%.0f,%.0f,", row.cost.clock.c_str(), row.cost.call_unit.c_str(),
               row.cost.per_sample, row.cost.call_p999, row.cost.call_max);
  if (row.cost.allocations_per_sample) std::fprintf(out, "%.5f", *row.cost.allocations_per_sample);
  std::fprintf(out, "\n");
}

}  // namespace

void print_table(std::FILE* out, const std::vector<Row>& rows) {
  std::fprintf(out,
               "| fitter | segments | per stroke | max error | mean error | strokes over | "
               "G1 > 5 deg | corners / weak | overshoot p99 / max / strokes beyond | ns / sample | "
               "call p99.9 / max, us | alloc / sample |\n"
               "|---|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|\n");
  for (const Row& row : rows) {
    std::fprintf(out, "| %s |", row.peer.c_str());
    if (!row.skipped.empty()) {
      std::fprintf(out, " skipped: %s ||||||||||||\n", row.skipped.c_str());
      continue;
    }
    print_result(out, row.total);
    print_cost(out, row.cost);
  }
}

void print_sources(std::FILE* out, const std::vector<Row>& rows) {
  std::set<std::string> sources;
  for (const Row& row : rows) {
    for (const auto& [source, report] : row.by_source) sources.insert(source);
  }
  for (const std::string& source : sources) {
    std::fprintf(
        out,
        "\n%s\n\n| fitter | segments | per stroke | max error | mean error | "
        "strokes over | G1 > 5 deg | corners / weak | overshoot p99 / max / strokes beyond |\n"
        "|---|---:|---:|---:|---:|---:|---:|---:|---:|\n",
        source.c_str());
    for (const Row& row : rows) {
      const auto found = row.by_source.find(source);
      if (found == row.by_source.end()) continue;
      std::fprintf(out, "| %s |", row.peer.c_str());
      print_result(out, found->second);
      std::fprintf(out, "\n");
    }
  }
}

void write_csv(const std::string& path, const std::vector<Row>& rows) {
  std::FILE* out = std::fopen(path.c_str(), "w");
  if (!out) throw std::runtime_error(path + ": cannot write");
  std::fprintf(out,
               "fitter,tolerance,source,strokes,samples,segments,max_error,mean_error,"
               "strokes_over,breaks_1e-3,breaks_5,corners,overshoot_p99,overshoot_max,"
               "overshoot_beyond,clock,call,ns_per_sample,call_p999_ns,call_max_ns,"
               "allocations_per_sample\n");
  for (const Row& row : rows) {
    if (!row.skipped.empty()) continue;
    write_csv_row(out, row, "all", row.total);
    for (const auto& [source, report] : row.by_source) write_csv_row(out, row, source, report);
  }
  if (std::fclose(out) != 0) throw std::runtime_error(path + ": cannot write");
}

}  // namespace felt::bench
