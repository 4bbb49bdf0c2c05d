#include "felt/motion/inbetween.h"

#include <benchmark/benchmark.h>

#include "felt/motion/testing/made_drawings.h"

namespace felt {
namespace {

struct Keys {
  Drawing from, to;
};

Keys keys_of(std::size_t count) {
  const auto strokes = testing::made_strokes(count, 1);
  const Similarity motion{{100, 100}, {120, 90}, 0.4, 1.1};
  return {testing::drawing_of(strokes),
          testing::drawing_of(testing::moved_strokes(strokes, motion, 0.4, 2))};
}

/// Finds the correspondence and prepares the in-betweens of two drawings. The argument is the
/// number of strokes in each.
void MotionPrepare(benchmark::State& state) {
  const Keys keys = keys_of(static_cast<std::size_t>(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(Inbetween::create(keys.from, keys.to, {}));
}
BENCHMARK(MotionPrepare)->Arg(20)->Arg(200)->Arg(2000)->Unit(benchmark::kMillisecond);

/// Makes the strokes of one in-between.
void MotionFrame(benchmark::State& state) {
  const Keys keys = keys_of(static_cast<std::size_t>(state.range(0)));
  const Inbetween motion = *Inbetween::create(keys.from, keys.to, {});
  double t = 0.0;
  for (auto _ : state) {
    t = t > 0.95 ? 0.04 : t + 0.04;
    benchmark::DoNotOptimize(motion.strokes_at(t));
  }
}
BENCHMARK(MotionFrame)->Arg(20)->Arg(200)->Arg(2000)->Unit(benchmark::kMillisecond);

/// Makes one in-between as a drawing.
void MotionDrawing(benchmark::State& state) {
  const Keys keys = keys_of(static_cast<std::size_t>(state.range(0)));
  const Inbetween motion = *Inbetween::create(keys.from, keys.to, {});
  double t = 0.0;
  for (auto _ : state) {
    t = t > 0.95 ? 0.04 : t + 0.04;
    benchmark::DoNotOptimize(motion.at(t));
  }
}
BENCHMARK(MotionDrawing)->Arg(200)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace felt
