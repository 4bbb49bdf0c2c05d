#include <benchmark/benchmark.h>

#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "felt/solid/inflate.h"
#include "felt/solid/testing/solid_drawings.h"

namespace felt {
namespace {

/// Returns a drawing of one closed stroke of 500 segments: a wavy outline of about 120 mm.
/// `mirror`: the outline mirrors itself.
Document outline_of_500(bool mirror) {
  constexpr int kSegments = 500;
  Random random(5);
  std::vector<std::pair<double, double>> waves;
  for (int k = 2; k < 12; ++k) {
    waves.emplace_back(random.between(0.0, 10.0) / k, mirror ? 0.0 : random.between(0.0, 6.0));
  }
  std::vector<Point> at;
  for (int i = 0; i < kSegments; ++i) {
    const double a = 2.0 * std::numbers::pi * i / kSegments;
    double r = 50.0;
    for (std::size_t k = 0; k < waves.size(); ++k) {
      r += waves[k].first * std::cos(static_cast<double>(k + 2) * a + waves[k].second);
    }
    at.push_back({100.0 + r * std::cos(a), 100.0 + r * std::sin(a)});
  }
  testing::SolidDrawing drawing;
  drawing.add(testing::stroke_of(testing::smooth_ring(at), true));
  return std::move(drawing.document);
}

/// Measures the inflation of one outline of 500 segments, from the strokes to the checked body. The
/// arguments are the number of triangles and whether the outline mirrors itself. The goal for 5,000
/// triangles is 150 ms.
void inflate_an_outline(benchmark::State& state) {
  const Document document = outline_of_500(state.range(1) != 0);
  const InflateOptions options{.triangles = static_cast<int>(state.range(0))};
  std::size_t triangles = 0;
  for (auto _ : state) {
    const Result<InflatedDrawing> result = inflate(document, options);
    if (!result) return state.SkipWithError(result.error().message.c_str());
    triangles = triangle_count(result->solid);
  }
  state.counters["triangles"] = static_cast<double>(triangles);
}
BENCHMARK(inflate_an_outline)
    ->Args({5000, 0})
    ->Args({5000, 1})
    ->Args({50'000, 0})
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace felt
