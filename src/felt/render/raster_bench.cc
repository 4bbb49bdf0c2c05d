#include <benchmark/benchmark.h>

#include <random>

#include "felt/render/page.h"
#include "felt/render/raster.h"
#include "felt/stroke/random_stroke.h"

namespace felt {
namespace {

/// Strokes of 1 to 8 segments about 125 px long and 1 to 6 px wide, anywhere on a full-HD screen
/// at 4 px/mm: the scene that rasterisers were compared on.
Sketch screen_of_strokes(int count) {
  std::mt19937_64 random(1);
  const auto uniform = [&](double a, double b) {
    return std::uniform_real_distribution<double>(a, b)(random);
  };
  Sketch sketch;
  for (int k = 0; k < count; ++k) {
    const int n = 1 + static_cast<int>(uniform(0.0, 8.0));
    StrokeData d;
    d.points.push_back({uniform(0.0, 480.0), uniform(0.0, 270.0)});
    double angle = uniform(0.0, 6.28);
    for (int i = 0; i < n; ++i) {
      for (int j = 0; j < 3; ++j) {
        d.points.push_back(d.points.back() + 2.3 * Vec{std::cos(angle), std::sin(angle)});
        if (j == 1 || i == 0) angle += uniform(-0.7, 0.7);
      }
      if (i > 0) d.joints.push_back(JointKind::kCorner);
      d.widths.push_back({static_cast<double>(i), uniform(0.25, 1.5)});
    }
    d.widths.push_back({static_cast<double>(n), uniform(0.25, 1.5)});
    d.color = {30, 30, 90, 128};
    sketch.push_back({"", Stroke::create(std::move(d)).value()});
  }
  return sketch;
}

/// The whole screen, outlines traced anew.
void FullScreen(benchmark::State& state) {
  const Sketch sketch = screen_of_strokes(static_cast<int>(state.range(0)));
  Image image = Image::create(1920, 1080).value();
  Rasterizer rasterizer;
  for (auto _ : state) {
    fill(image.pixels(), {0, 0, 1920, 1080}, {255, 255, 255, 255});
    for (const auto& s : sketch) {
      rasterizer.draw(s.stroke, {{0, 0}, 4.0}, {0, 0, 1920, 1080}, image.pixels());
    }
  }
  state.SetItemsProcessed(state.iterations() * state.range(0));
}
BENCHMARK(FullScreen)->Arg(1000)->Arg(10000)->Unit(benchmark::kMillisecond);

/// A dirty patch of 64 x 64 pixels; every stroke is asked whether it touches it.
void DirtyPatch(benchmark::State& state) {
  const Sketch sketch = screen_of_strokes(static_cast<int>(state.range(0)));
  Image image = Image::create(1920, 1080).value();
  Rasterizer rasterizer;
  const PixelRect patch{900, 500, 964, 564};
  for (auto _ : state) {
    fill(image.pixels(), patch, {255, 255, 255, 255});
    for (const auto& s : sketch) {
      rasterizer.draw(s.stroke, {{0, 0}, 4.0}, patch, image.pixels());
    }
  }
}
BENCHMARK(DirtyPatch)->Arg(1000)->Arg(10000)->Unit(benchmark::kMicrosecond);

void TraceOutlines(benchmark::State& state) {
  const Sketch sketch = screen_of_strokes(1000);
  const double tolerance_px = 1.0 / static_cast<double>(state.range(0));
  StrokeOutliner outliner;
  std::size_t points = 0;
  for (auto _ : state) {
    points = 0;
    for (const auto& s : sketch)
      points += outliner.trace(s.stroke, tolerance_px / 4.0).points.size();
  }
  state.SetItemsProcessed(state.iterations() * 1000);
  state.counters["points_per_stroke"] = static_cast<double>(points) / 1000.0;
}
BENCHMARK(TraceOutlines)->Arg(10)->Arg(20)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace felt
