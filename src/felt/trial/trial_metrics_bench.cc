#include <benchmark/benchmark.h>

#include <cmath>
#include <random>
#include <vector>

#include "felt/trial/trial_metrics.h"

namespace felt {
namespace {

std::vector<Point> spiral() {
  std::vector<Point> path;
  for (int i = 0; i < 2000; ++i)
    path.push_back(Point{100.0, 100.0} + 0.04 * i * Vec{std::cos(0.02 * i), std::sin(0.02 * i)});
  return path;
}

std::vector<TrialSample> samples_at(std::int64_t count, auto position) {
  std::vector<TrialSample> samples;
  for (std::int64_t i = 0; i < count; ++i) {
    TrialSample sample{.time_ns = i * 1'000'000, .contact = true};
    sample.position = position(static_cast<double>(i) / static_cast<double>(count));
    sample.force_n = Vec{0.1, 0.2};
    samples.push_back(sample);
  }
  return samples;
}

void MeasureTracedSpiral(benchmark::State& state) {
  const std::vector<Point> path = spiral();
  const auto samples = samples_at(state.range(0), [](double u) {
    const double turn = 40.0 * u;
    return Point{100.0, 100.0} +
           (80.0 * u + 0.5 * std::sin(200.0 * u)) * Vec{std::cos(turn), std::sin(turn)};
  });
  for (auto _ : state) benchmark::DoNotOptimize(measure_trial(samples, path));
}
BENCHMARK(MeasureTracedSpiral)
    ->Arg(1'000)
    ->Arg(10'000)
    ->Arg(100'000)
    ->Unit(benchmark::kMillisecond);

// Each sample is anywhere on the page, so that lines of ink are long and cross each other.
void MeasureNoise(benchmark::State& state) {
  const std::vector<Point> path = spiral();
  std::mt19937 engine(1);
  const auto samples = samples_at(state.range(0), [&](double) {
    return Point{0.05 * static_cast<double>(engine() % 4000),
                 0.05 * static_cast<double>(engine() % 4000)};
  });
  for (auto _ : state) benchmark::DoNotOptimize(measure_trial(samples, path));
}
BENCHMARK(MeasureNoise)->Arg(1'000)->Arg(10'000)->Arg(100'000)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace felt
