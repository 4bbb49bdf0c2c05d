#include <benchmark/benchmark.h>

#include "felt/render/raster.h"
#include "felt/stroke/testing/screen_of_strokes.h"

namespace felt {
namespace {

/// Draws the whole screen and traces all outlines again.
void FullScreen(benchmark::State& state) {
  const std::vector<Stroke> strokes = testing::screen_of_strokes(static_cast<int>(state.range(0)));
  Image image = Image::create(1920, 1080).value();
  Rasterizer rasterizer;
  for (auto _ : state) {
    fill(image.pixels(), {0, 0, 1920, 1080}, {255, 255, 255, 255});
    for (const Stroke& s : strokes) {
      rasterizer.draw(s, {{0, 0}, 4.0}, {0, 0, 1920, 1080}, image.pixels());
    }
  }
  state.SetItemsProcessed(state.iterations() * state.range(0));
}
BENCHMARK(FullScreen)->Arg(1000)->Arg(10000)->Unit(benchmark::kMillisecond);

/// Does the same with the look of a medium on a relief. The range is 0 for plain ink, or the number
/// of a medium in media() from 1.
void FullScreenOfMedium(benchmark::State& state) {
  const auto n = static_cast<std::size_t>(state.range(0));
  static const HeightField relief(
      {.wavelength_mm = 1.3, .rms_um = 11.0, .seed = 11, .character = HeightCharacter::kRough});
  Materials materials = Materials::built_in();
  if (n > 0) {
    Medium medium = materials.media()[n - 1];
    state.SetLabel(medium.id);
    medium.id = "pencil";
    materials.put(medium);
  }
  const Grain grain = n == 0 ? Grain() : Grain(&relief, materials);
  const std::vector<Stroke> strokes = testing::screen_of_strokes(1000);
  Image image = Image::create(1920, 1080).value();
  Rasterizer rasterizer;
  rasterizer.draw(strokes[0], {{0, 0}, 4.0}, {0, 0, 1920, 1080}, grain, image.pixels());
  for (auto _ : state) {
    fill(image.pixels(), {0, 0, 1920, 1080}, {255, 255, 255, 255});
    for (const Stroke& s : strokes) {
      rasterizer.draw(s, {{0, 0}, 4.0}, {0, 0, 1920, 1080}, grain, image.pixels());
    }
  }
}
BENCHMARK(FullScreenOfMedium)->DenseRange(0, 9)->Unit(benchmark::kMillisecond);

/// Draws one stroke of a pencil that fills a third of the screen with a zigzag and crosses itself
/// everywhere.
void Scribble(benchmark::State& state) {
  static const HeightField relief(
      {.wavelength_mm = 1.3, .rms_um = 11.0, .seed = 11, .character = HeightCharacter::kRough});
  const Grain grain(&relief);
  StrokeData data;
  data.points = {{20, 20}};
  constexpr int kLines = 400;
  for (int i = 1; i <= kLines; ++i) {
    const Point from = data.points.back();
    const Point to{20.0 + 1.0 * i, i % 2 == 0 ? 20.0 : 140.0};
    data.points.insert(data.points.end(), {from + Vec{10, 5}, to - Vec{30, 5}, to});
  }
  data.joints.assign(kLines - 1, JointKind::kCorner);
  data.widths = {{0.0, 0.6, 0.5}, {1.0 * kLines, 1.2, 0.5}};
  data.medium = "pencil";
  const Stroke stroke = Stroke::create(std::move(data)).value();
  Image image = Image::create(1920, 1080).value();
  Rasterizer rasterizer;
  for (auto _ : state) {
    fill(image.pixels(), {0, 0, 1920, 1080}, {255, 255, 255, 255});
    rasterizer.draw(stroke, {{0, 0}, 4.0}, {0, 0, 1920, 1080}, grain, image.pixels());
  }
}
BENCHMARK(Scribble)->Unit(benchmark::kMillisecond);

/// Draws one pencil stroke of many segments in tiles of 256 pixels, as a window does. The range is
/// the number of segments.
void LongStrokeInTiles(benchmark::State& state) {
  static const HeightField relief(
      {.wavelength_mm = 1.3, .rms_um = 11.0, .seed = 11, .character = HeightCharacter::kRough});
  const Grain grain(&relief);
  const auto count = static_cast<int>(state.range(0));
  StrokeData data;
  data.points = {{20, 20}};
  for (int i = 1; i <= count; ++i) {
    const Point from = data.points.back();
    const Point to{20.0 + 400.0 * i / count, i % 2 == 0 ? 20.0 : 22.0};
    data.points.insert(data.points.end(), {from + Vec{0.0, 0.5}, to - Vec{0.0, 0.5}, to});
  }
  data.joints.assign(static_cast<std::size_t>(count) - 1, JointKind::kCorner);
  data.widths = {{0.0, 0.6, 0.5}, {1.0 * count, 1.2, 0.5}};
  data.medium = "pencil";
  const Stroke stroke = Stroke::create(std::move(data)).value();
  constexpr int kSide = 256;
  Image image = Image::create(kSide, kSide).value();
  Rasterizer rasterizer;
  for (auto _ : state) {
    for (int x = 0; x < 5120; x += kSide) {
      fill(image.pixels(), {0, 0, kSide, kSide}, {255, 255, 255, 255});
      const View view = View::at_dpi({0, 0}, 300.0).from({1.0 * x, kSide});
      rasterizer.draw(stroke, view, {0, 0, kSide, kSide}, grain, image.pixels());
    }
  }
  state.SetItemsProcessed(state.iterations() * 20);
}
BENCHMARK(LongStrokeInTiles)->Arg(1000)->Arg(20000)->Unit(benchmark::kMillisecond);

/// Draws a dirty patch of 64 x 64 pixels. Checks for each stroke if it touches the patch.
void DirtyPatch(benchmark::State& state) {
  const std::vector<Stroke> strokes = testing::screen_of_strokes(static_cast<int>(state.range(0)));
  Image image = Image::create(1920, 1080).value();
  Rasterizer rasterizer;
  const PixelRect patch{900, 500, 964, 564};
  for (auto _ : state) {
    fill(image.pixels(), patch, {255, 255, 255, 255});
    for (const Stroke& s : strokes) {
      rasterizer.draw(s, {{0, 0}, 4.0}, patch, image.pixels());
    }
  }
}
BENCHMARK(DirtyPatch)->Arg(1000)->Arg(10000)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace felt
