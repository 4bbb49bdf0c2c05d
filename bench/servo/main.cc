// Measures the cost of a tick of the haptic loop as thread CPU time. The system call that reads the
// clock has a cost of its own, which is printed and not subtracted. The mean is from a separate run
// without these calls.
//   bench_servo [--ticks N]          prints the table (200000 ticks per row by default)
//   bench_servo --loop SECONDS       runs the loop in real time on this machine
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <memory>
#include <string_view>
#include <vector>

#include "felt/base/constants.h"
#include "felt/devices/simulated/simulated_stylus.h"
#include "felt/geometry/testing/ball.h"
#include "felt/haptics/bricks/damping.h"
#include "felt/haptics/bricks/drawing_feel.h"
#include "felt/haptics/bricks/snap_well.h"
#include "felt/haptics/bricks/solid_surface.h"
#include "felt/haptics/bricks/spring.h"
#include "felt/haptics/force_model.h"
#include "felt/rt/null_device.h"
#include "felt/rt/realtime_thread.h"
#include "felt/rt/servo.h"

namespace felt::bench {
namespace {

std::int64_t cpu_ns() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return now.tv_sec * std::int64_t{1'000'000'000} + now.tv_nsec;
}

void print_row(const char* what, std::vector<std::int64_t>& each, double mean_ns) {
  std::sort(each.begin(), each.end());
  const auto at_us = [&](double q) {
    const auto rank = static_cast<std::size_t>(q * static_cast<double>(each.size()));
    return 1e-3 * static_cast<double>(each[std::min(rank, each.size() - 1)]);
  };
  std::printf("%-44s %8.3f %8.2f %8.2f %8.2f %8.2f\n", what, 1e-3 * mean_ns, at_us(0.5),
              at_us(0.99), at_us(0.999), at_us(1.0));
}

// Returns a force model with all kinds of force: surface with grain and friction, springs of the
// edit, snap wells, damping.
ForceModel everything(const Capabilities& device, std::uint32_t fade_id) {
  const SurfaceMaterial& paper = surface_materials()[0];
  const std::array<Point, 4> targets{Point{70, 50}, Point{75, 50}, Point{70, 55}, Point{60, 50}};
  ForceModel model(Compose(make_surface_force(paper, media()[0], device, surface_grain(paper)),
                           EditSpring(Point{70, 50}),
                           SweepSpring({.pen = {70, 50}, .curve = {70, 50}, .normal = {0, 1}}),
                           SnapWells(targets), Damping({.where = DampingWhere::kEverywhere})));
  model.set_fade_id(fade_id);
  return model;
}

ForceModel paper_only(const Capabilities& device, std::uint32_t fade_id) {
  ForceModel model(make_surface_force(surface_materials()[0], media()[0], device));
  model.set_fade_id(fade_id);
  return model;
}

// Returns the surface of a body with `around`^2 * 2 triangles below the scribbling hand.
template <int around>
ForceModel body(const Capabilities& device, std::uint32_t fade_id) {
  static const TriangleTree tree(testing::ball({70, 50, -15}, {30, 25, 15.5}, around, around));
  const SurfaceMaterial& paper = surface_materials()[0];
  ForceModel model(
      make_solid_surface(tree, paper, media()[0], device, fade_id, surface_grain(paper)));
  model.set_fade_id(fade_id);
  return model;
}

using MakeModel = ForceModel (*)(const Capabilities&, std::uint32_t);

// Times ticks with a scribbling hand. Publishes a new model every `change_every` ticks; 0 means
// that it publishes only one, before the first tick.
template <class D>
void bench_ticks(const char* what, D& device, MakeModel make, int change_every, int ticks) {
  ServoOptions options;
  options.limits = limits_for(device.capabilities());
  const auto servo = std::make_unique<Servo>(device, options);
  servo->arm();
  std::vector<std::int64_t> each;
  double mean_ns = 0.0;
  std::int64_t now_ns = 0;
  std::vector<PenSample> drained(1000);
  for (const bool one_by_one : {false, true}) {  // the first round is also the warm-up
    std::int64_t sum_ns = 0;
    for (int tick = 0; tick < ticks;) {
      // The hand moves once per batch of up to 100 ticks, outside the timed part.
      const double t_s = 1e-9 * static_cast<double>(now_ns);
      device.aim({70 + 8 * std::sin(3 * t_s), 50 + 6 * std::cos(4 * t_s), -1 - std::sin(2 * t_s)},
                 {}, 0);
      servo->heartbeat(now_ns);
      if (make != nullptr && (tick == 0 || (change_every > 0 && tick % change_every == 0))) {
        servo->publish(make(device.capabilities(), static_cast<std::uint32_t>(tick + 1)));
      }
      while (servo->for_edit().pop(drained) + servo->for_autosave().pop(drained) > 0) {
      }
      const int batch = change_every > 0 ? std::min(change_every, 100) : 100;
      const std::int64_t batch_ns = cpu_ns();
      for (int i = 0; i < batch; ++i, ++tick, now_ns += kMs) {
        const std::int64_t start_ns = one_by_one ? cpu_ns() : 0;
        servo->step(now_ns);
        if (one_by_one) each.push_back(cpu_ns() - start_ns);
      }
      sum_ns += cpu_ns() - batch_ns;
    }
    if (!one_by_one) mean_ns = static_cast<double>(sum_ns) / ticks;
  }
  print_row(what, each, mean_ns);
}

// Prints the mean of many calls.
template <class Call>
void bench_call(const char* what, Call call) {
  constexpr int kCalls = 1'000'000;
  for (int i = 0; i < kCalls / 10; ++i) call(i);
  const std::int64_t start_ns = cpu_ns();
  for (int i = 0; i < kCalls; ++i) call(i);
  std::printf("%-44s %8.1f\n", what, static_cast<double>(cpu_ns() - start_ns) / kCalls);
}

void bench_hand_over() {
  std::printf("\nhand-over on one thread, ns\n");
  const auto ring = std::make_unique<Servo::Ring>();
  PenSample sample;
  bench_call("SpscRing<PenSample>: push and pop", [&](int i) {
    sample.time_ns = i;
    ring->push(sample);
    ring->pop(sample);
  });
  const auto models = std::make_unique<LatestValue<ForceModel>>();
  ForceModel model = paper_only({}, 1);
  bench_call("LatestValue<ForceModel> (2 KiB): publish, get", [&](int i) {
    model.set_fade_id(static_cast<std::uint32_t>(i));
    models->publish(model);
    models->update();
  });
  bench_call("LatestValue: update() with nothing new", [&](int) { models->update(); });
  const auto reports = std::make_unique<LatestValue<TickReport>>();
  TickReport report;
  bench_call("LatestValue<TickReport>: publish", [&](int i) {
    report.dt_s = i;
    reports->publish(report);
  });
}

void bench_table(int ticks) {
  std::array<std::int64_t, 1001> empty{};
  for (std::int64_t& ns : empty) {
    const std::int64_t start_ns = cpu_ns();
    ns = cpu_ns() - start_ns;
  }
  std::nth_element(empty.begin(), empty.begin() + 500, empty.end());
  std::printf("thread CPU, us; reading the clock costs %.2f, part of all but the mean\n",
              1e-3 * static_cast<double>(empty[500]));
  std::printf("%-44s %8s %8s %8s %8s %8s\n", "one tick", "mean", "p50", "p99", "p99.9", "max");
  NullDevice none;
  bench_ticks("no device, no force", none, nullptr, 0, ticks);
  const StylusPreset& preset = *find_stylus_preset("touch");
  const auto row = [&](const char* what, MakeModel make, int change_every) {
    SimulatedStylus stylus(preset);  // a new one, because time starts again at 0
    bench_ticks(what, stylus, make, change_every, ticks);
  };
  row("simulated stylus, no force", nullptr, 0);
  row("simulated stylus on paper", paper_only, 0);
  row("everything on", everything, 0);
  row("everything on, another feel every 20 ms", everything, 20);
  row("touching a body of 5000 triangles", body<50>, 0);
  row("touching a body of 100,000 triangles", body<224>, 0);
  row("touching a body of 1,000,000 triangles", body<708>, 0);
  row("100,000 triangles, another body every 20 ms", body<224>, 20);
  bench_hand_over();
}

int run_loop(double seconds) {
  SimulatedStylus stylus(*find_stylus_preset("touch"));
  ServoOptions options;
  options.limits = limits_for(stylus.capabilities());
  const auto servo = std::make_unique<Servo>(stylus, options);
  servo->publish(everything(stylus.capabilities(), 1));
  servo->arm();
  RealtimeOptions realtime;
  realtime.measure_cpu = true;
  RealtimeThread loop(*servo, realtime);
  if (const auto started = loop.start(); !started) {
    std::fprintf(stderr, "%s\n", started.error().message.c_str());
    return 1;
  }
  std::printf("%s\n", describe(loop.status()).c_str());
  std::vector<PenSample> drained(100);
  const auto end_ns = static_cast<std::int64_t>(1e9 * seconds);
  while (loop.now_ns() < end_ns) {
    servo->heartbeat(loop.now_ns());
    const double t_s = 1e-9 * static_cast<double>(loop.now_ns());
    stylus.aim({70 + 8 * std::sin(3 * t_s), 50.0, -1 - 2 * std::sin(2 * t_s)}, {}, 0);
    while (servo->for_edit().pop(drained) + servo->for_autosave().pop(drained) > 0) {
    }
    const timespec nap{0, 4 * kMs};
    nanosleep(&nap, nullptr);
  }
  if (!loop.stop()) std::printf("the loop hangs\n");
  std::printf("%s\n", describe(loop.stats()).c_str());
  return 0;
}

}  // namespace
}  // namespace felt::bench

int main(int argc, char** argv) {
  int ticks = 200'000;
  for (int i = 1; i < argc; ++i) {
    const std::string_view word = argv[i];
    if (word == "--loop" && i + 1 < argc) return felt::bench::run_loop(std::atof(argv[i + 1]));
    if (word == "--ticks" && i + 1 < argc) {
      ticks = std::max(std::atoi(argv[++i]), 100);
    } else {
      std::fprintf(stderr, "usage: %s [--ticks N] | --loop SECONDS\n", argv[0]);
      return 2;
    }
  }
  felt::bench::bench_table(ticks);
  return 0;
}
