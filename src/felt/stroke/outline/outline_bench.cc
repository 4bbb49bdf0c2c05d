#include "felt/stroke/outline/outline.h"

#include <benchmark/benchmark.h>

#include "felt/stroke/outline/outline_path.h"
#include "felt/stroke/testing/screen_of_strokes.h"

namespace felt {
namespace {

constexpr double kPxPerMm = 4.0;

/// Measures outlines as polygons, at a tolerance of 1 / range px.
void OutlinePolygon(benchmark::State& state) {
  const std::vector<Stroke> strokes = testing::screen_of_strokes(1000);
  const double tolerance_mm = 1.0 / (kPxPerMm * static_cast<double>(state.range(0)));
  StrokeOutliner outliner;
  std::size_t points = 0;
  for (auto _ : state) {
    points = 0;
    for (const Stroke& s : strokes) points += outliner.trace(s, tolerance_mm).points.size();
  }
  state.SetItemsProcessed(state.iterations() * 1000);
  state.counters["points_per_stroke"] = static_cast<double>(points) / 1000.0;
}
BENCHMARK(OutlinePolygon)->Arg(10)->Arg(20)->Unit(benchmark::kMicrosecond);

/// Measures outlines as curves, as they are written to an SVG file.
void OutlineCurves(benchmark::State& state) {
  const std::vector<Stroke> strokes = testing::screen_of_strokes(1000);
  std::size_t points = 0;
  for (auto _ : state) {
    points = 0;
    for (const Stroke& s : strokes) points += outline_path(s, 0.005).points.size();
  }
  state.SetItemsProcessed(state.iterations() * 1000);
  state.counters["points_per_stroke"] = static_cast<double>(points) / 1000.0;
}
BENCHMARK(OutlineCurves)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace felt
