#include "fit_stats.h"

#include <fmt/core.h>
#include <time.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "allocation_counter.h"
#include "felt/io/ndjson/ndjson_writer.h"

namespace felt::cli {
namespace {

/// Returns the median time between two consecutive readings of the clock.
std::int64_t measure_clock_cost() {
  std::array<std::int64_t, 501> costs{};
  for (std::int64_t& cost : costs) {
    const std::int64_t start = thread_cpu_ns();
    cost = thread_cpu_ns() - start;
  }
  std::nth_element(costs.begin(), costs.begin() + costs.size() / 2, costs.end());
  return costs[costs.size() / 2];
}

}  // namespace

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

std::int64_t thread_cpu_ns() noexcept {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return std::int64_t{1'000'000'000} * now.tv_sec + now.tv_nsec;
}

StrokeMeter::StrokeMeter(const InkFitOptions& options)
    : fitter_(options), clock_cost_ns_(measure_clock_cost()) {}

void StrokeMeter::measure_calls(std::span<const InkSample> samples, FitStats& stats) {
  min_ns_.assign(samples.size(), std::numeric_limits<std::int64_t>::max());
  std::int64_t allocations = 0;
  for (int i = 0; i < kRuns; ++i) run(samples, allocations);
  stats.allocations += allocations;
  for (const std::int64_t ns : min_ns_) stats.calls.add(ns - clock_cost_ns_);
}

void StrokeMeter::run(std::span<const InkSample> samples, std::int64_t& allocations) {
  fitter_.begin();
  const std::int64_t allocations_before = thread_allocations();
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const std::int64_t start = thread_cpu_ns();
    fitter_.push(samples[i]);
    min_ns_[i] = std::min(min_ns_[i], thread_cpu_ns() - start);
  }
  allocations = thread_allocations() - allocations_before;
  fitter_.end();
}

void StrokeMeter::measure_error(std::span<const InkSample> samples, const Stroke& stroke,
                                FitStats& stats) {
  segments_.clear();
  for (int i = 0; i < stroke.segment_count(); ++i) {
    segments_.push_back({stroke.segment(i), {0, static_cast<std::uint32_t>(i)}});
  }
  tree_.build(segments_);
  SegmentBvh::Query query;
  query.cap = {std::numeric_limits<int>::max(), std::numeric_limits<int>::max()};
  for (const InkSample& sample : samples) {
    query.point = sample.position;
    const SegmentBvh::Hit hit = tree_.nearest(query);
    query.seed = hit.handle;  // the next sample is near the same segment
    const double error_mm = std::sqrt(hit.nearest.distance_squared);
    stats.max_error_mm = std::max(stats.max_error_mm, error_mm);
    stats.error_sum_mm += error_mm;
  }
}

}  // namespace felt::cli
