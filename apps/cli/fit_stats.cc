#include "fit_stats.h"

#include <fmt/core.h>

#include <algorithm>

#include "felt/io/ndjson/ndjson_writer.h"

namespace felt::cli {

void FitStats::add(const FitStats& other) noexcept {
  strokes += other.strokes;
  samples += other.samples;
  segments += other.segments;
  corners += other.corners;
  max_error_mm = std::max(max_error_mm, other.max_error_mm);
  error_sum_mm += other.error_sum_mm;
  fit_ns += other.fit_ns;
  refine_ns += other.refine_ns;
  allocations += other.allocations;
  calls.add(other.calls);
}

double per(double sum, std::int64_t count) noexcept {
  return count > 0 ? sum / static_cast<double>(count) : 0.0;
}

std::string stats_json(const FitStats& stats) {
  std::string max_error, mean_error;
  append_number(max_error, stats.max_error_mm);
  append_number(mean_error, per(stats.error_sum_mm, stats.samples));
  return fmt::format(R"({{"strokes":{},"samples":{},"segments":{},"corners":{},)"
                     R"("max_error_mm":{},"mean_error_mm":{},)"
                     R"("ns_per_sample":{{"mean":{:.1f},"p999":{},"max":{}}},)"
                     R"("refine_ns_per_sample":{:.1f},"allocations_per_sample":{:.6g}}})"
                     "\n",
                     stats.strokes, stats.samples, stats.segments, stats.corners, max_error,
                     mean_error, per(static_cast<double>(stats.fit_ns), stats.samples),
                     stats.calls.quantile(0.999), stats.calls.max(),
                     per(static_cast<double>(stats.refine_ns), stats.samples),
                     per(static_cast<double>(stats.allocations), stats.samples));
}

}  // namespace felt::cli
