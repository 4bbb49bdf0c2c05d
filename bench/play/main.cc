/// Measures how much faster than real time a script plays (`real_time_factor`), with device, hand,
/// plane, friction, safety chain, session and fit. Parts are also measured separately: a loop
/// without hand and plane, and the session without a loop.
///
///   build/release/bin/bench_play

#include <benchmark/benchmark.h>

#include <cmath>

#include "felt/base/constants.h"
#include "felt/devices/simulated/simulated_stylus.h"
#include "felt/rt/null_device.h"
#include "felt/session/player.h"

namespace felt {
namespace {

/// Returns the events of a minute of writing: one loop 8 mm wide per second. The pen is lifted for
/// 0.2 s of each second.
template <class What>
std::vector<Event> minute() {
  std::vector<Event> events;
  for (std::int64_t ms = 0; ms < 60'000; ms += 8) {
    const double s = 1e-3 * static_cast<double>(ms);
    const double z = ms < 1000 || ms % 1000 < 200 ? 3.0 : -1.5;
    const Vec3 at{20.0 + 1.5 * s + 4.0 * std::cos(6.283 * s), 40.0 + 4.0 * std::sin(12.566 * s), z};
    events.push_back({ms * kMs, What{at, {}, 0}});
  }
  return events;
}

void report(benchmark::State& state, const PlayReport& played) {
  const double seconds = 1e-9 * static_cast<double>(played.end_ns - played.start_ns);
  state.counters["real_time_factor"] =
      benchmark::Counter(seconds, benchmark::Counter::kIsIterationInvariantRate);
  state.counters["edits"] = static_cast<double>(played.edits);
}

template <class What>
void play_touch(benchmark::State& state) {
  const std::vector<Event> events = minute<What>();
  PlayReport played;
  for (auto _ : state) {
    SimulatedStylus stylus(*find_stylus_preset("touch"));
    Session session(make_tools(), {.device = stylus.capabilities()});
    PlayerOptions options;
    options.period_ns = state.range(0) * 1000;
    Player player(stylus, &stylus, session, options);
    played = player.play(events).value();
  }
  report(state, played);
}
BENCHMARK(play_touch<HandEvent>)->Arg(1000)->Arg(250)->Unit(benchmark::kMillisecond);
BENCHMARK(play_touch<PenEvent>)->Arg(1000)->Unit(benchmark::kMillisecond);

void play_nothing(benchmark::State& state) {
  const std::vector<Event> events = minute<PenEvent>();
  PlayReport played;
  for (auto _ : state) {
    NullDevice nothing;
    Session session(make_tools(), {.device = nothing.capabilities()});
    Player player(nothing, nullptr, session, {});
    played = player.play(events).value();
  }
  report(state, played);
}
BENCHMARK(play_nothing)->Unit(benchmark::kMillisecond);

/// Passes the same samples directly to the session, without a haptic loop.
void session_alone(benchmark::State& state) {
  const std::vector<Event> events = minute<PenEvent>();
  for (auto _ : state) {
    Session session(make_tools(), {});
    for (std::int64_t ms = 0; ms < 60'000; ++ms) {
      const auto& pen = std::get<PenEvent>(events[static_cast<std::size_t>(ms / 8)].what);
      benchmark::DoNotOptimize(session.sample({ms * kMs, pen.position, {}, {}, 0}));
    }
  }
  state.counters["real_time_factor"] =
      benchmark::Counter(60.0, benchmark::Counter::kIsIterationInvariantRate);
}
BENCHMARK(session_alone)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace felt
