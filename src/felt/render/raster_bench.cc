#include <benchmark/benchmark.h>

#include "felt/render/raster.h"
#include "felt/stroke/screen_of_strokes.h"

namespace felt {
namespace {

/// The whole screen, outlines traced anew.
void FullScreen(benchmark::State& state) {
  const Sketch sketch = testing::screen_of_strokes(static_cast<int>(state.range(0)));
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
  const Sketch sketch = testing::screen_of_strokes(static_cast<int>(state.range(0)));
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

}  // namespace
}  // namespace felt
