#include <benchmark/benchmark.h>

#include <memory>
#include <vector>

#include "felt/base/random.h"
#include "felt/fill/follow_fill.h"
#include "felt/stroke/testing/screen_of_strokes.h"

namespace felt {
namespace {

/// Returns 1,000 strokes of a screen as lines of a map.
std::vector<FillLine> lines_of_screen() {
  std::vector<FillLine> lines;
  for (Stroke& s : testing::screen_of_strokes(1000)) {
    lines.push_back({StrokeId{lines.size() + 1}, std::make_shared<const Stroke>(std::move(s))});
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

/// Measures one edit of a drawing of 1,000 strokes: one stroke moves by a millimetre, the map is
/// updated, and the fills follow. The argument is the size of gaps in mm.
void FillEdit(benchmark::State& state) {
  const auto gap_mm = static_cast<double>(state.range(0));
  std::vector<FillLine> lines = lines_of_screen();
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
    benchmark::DoNotOptimize(map.map(gap_mm).counts());
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
BENCHMARK(FillEdit)->Arg(0)->Arg(3)->Unit(benchmark::kMillisecond);

/// Measures the first map of 1,000 strokes.
void FillFirstMap(benchmark::State& state) {
  const std::vector<FillLine> lines = lines_of_screen();
  for (auto _ : state) {
    FillMap map;
    map.update(lines);
    benchmark::DoNotOptimize(map.map(3.0).counts());
  }
}
BENCHMARK(FillFirstMap)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace felt
