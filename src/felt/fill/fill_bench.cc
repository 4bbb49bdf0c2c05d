#include <benchmark/benchmark.h>

#include <memory>
#include <vector>

#include "felt/base/random.h"
#include "felt/fill/follow_fill.h"
#include "felt/stroke/testing/screen_of_strokes.h"

namespace felt {
namespace {

/// Returns screens of 1,000 strokes each, side by side, as lines of a map.
std::vector<FillLine> lines_of_screens(std::int64_t strokes) {
  constexpr double kScreenMm = 500.0;
  const std::vector<Stroke> screen = testing::screen_of_strokes(1000);
  std::vector<FillLine> lines;
  for (std::size_t i = 0; i < static_cast<std::size_t>(strokes); ++i) {
    StrokeData data = screen[i % screen.size()].data();
    const auto number = static_cast<double>(i / screen.size());
    for (Point& p : data.points) p += Vec{kScreenMm * number, 0.0};
    lines.push_back(
        {StrokeId{i + 1}, std::make_shared<const Stroke>(Stroke::create(std::move(data)).value())});
  }
  return lines;
}

std::vector<Fill> some_fills(FillMap& map, double gap_mm) {
  Random random(3);
  std::vector<Fill> fills;
  for (int i = 0; i < 1000 && fills.size() < 100; ++i) {
    const Point p{random.between(0.0, 480.0), random.between(0.0, 270.0)};
    const auto loop = map.map(gap_mm).loop_around(p);
    if (loop) fills.push_back(map.fill_of(*loop, gap_mm, {}).fill);
  }
  return fills;
}

/// Measures one edit of a drawing: one stroke moves by a millimetre, and the fills follow. The
/// arguments are the number of strokes, the size of gaps in mm, and whether the map is also asked
/// for a face, which divides all lines again.
void FillEdit(benchmark::State& state) {
  const auto gap_mm = static_cast<double>(state.range(1));
  std::vector<FillLine> lines = lines_of_screens(state.range(0));
  FillMap map;
  map.update(lines);
  std::vector<Fill> fills = some_fills(map, gap_mm);
  std::size_t next = 0, followed = 0;
  double shift = 1.0;
  for (auto _ : state) {
    FillLine& line = lines[next];
    StrokeData data = line.stroke->data();
    for (Point& p : data.points) p += Vec{shift, 0.0};
    line.stroke = std::make_shared<const Stroke>(Stroke::create(data).value());
    map.update({&line, 1});
    if (state.range(2) != 0) benchmark::DoNotOptimize(map.map(gap_mm).counts());
    for (Fill& fill : fills) {
      auto now = follow_fill(fill, map, {}, WhenOpened::kClose);
      if (!now) continue;
      fill = std::move(*now);
      ++followed;
    }
    next = (next + 37) % lines.size();
    if (next == 0) shift = -shift;
  }
  const MapCounts counts = map.map(gap_mm).counts();
  state.counters["fills"] = static_cast<double>(fills.size());
  state.counters["followed"] =
      static_cast<double>(followed) / static_cast<double>(state.iterations());
  state.counters["edges"] = static_cast<double>(counts.edges);
  state.counters["faces"] = static_cast<double>(counts.faces);
}
BENCHMARK(FillEdit)
    ->ArgNames({"strokes", "gap", "face"})
    ->ArgsProduct({{1'000, 10'000}, {0, 3}, {0, 1}})
    ->Unit(benchmark::kMillisecond);

/// Measures the first map of a drawing.
void FillFirstMap(benchmark::State& state) {
  const std::vector<FillLine> lines = lines_of_screens(state.range(0));
  for (auto _ : state) {
    FillMap map;
    map.update(lines);
    benchmark::DoNotOptimize(map.map(3.0).counts());
  }
}
BENCHMARK(FillFirstMap)->Arg(1'000)->Arg(10'000)->Arg(100'000)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace felt
