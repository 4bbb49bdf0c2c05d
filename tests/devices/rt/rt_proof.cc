// Proves that a tick of the haptic loop allocates nothing, locks nothing, makes no system call,
// touches no new page and does not yield the processor (docs/design/loop.md#what-is-proven).
//   rt_proof [--ticks N] [SCENARIO...]   runs all scenarios, or those named; exit 3 on a violation
//   rt_proof --plant NAME                plants a violation that must be detected: exit 3; exit 77
//                                        if this system cannot detect it
//   rt_proof --list | --list-plants      prints the names of the scenarios or plants
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string_view>
#include <vector>

#include "felt/rt/null_device.h"
#include "tests/devices/drivers/scripted_bench.h"
#include "tests/devices/rt/driver_scenario.h"
#include "tests/devices/rt/plants.h"
#include "tests/devices/rt/scenarios.h"
#include "tests/devices/rt/tick_watch.h"

namespace felt::rt_test {
namespace {

struct Planted {
  void (*commit)() noexcept;
  Force operator()(const PenSample&, ForceMemory&) const noexcept {
    commit();
    return {};
  }
  [[nodiscard]] static Slopes slopes() noexcept { return {}; }
};

struct Ran {
  int ticks = 0;    // watched ticks
  int pushing = 0;  // watched ticks that sent a force
};

Ran run_ticks(Session& session, int ticks_wanted) {
  const std::int64_t period_ns = session.servo().options().period_ns;
  const int warm_up = session.warm_up_ticks();
  const int ticks = std::max(ticks_wanted, session.min_ticks() - warm_up);
  Ran ran{.ticks = ticks};
  for (int tick = 0; tick < warm_up + ticks; ++tick) {
    const std::int64_t now_ns = tick * period_ns;
    session.edit(tick, now_ns);
    Servo& servo = session.servo();  // a new servo if a device was reopened
    const bool watched = tick >= warm_up;
    if (tick == warm_up) touch_code();
    if (watched) begin_watch();
    const TickReport& report = servo.step(now_ns);
    if (watched) end_watch();
    if (watched && report.sent != Force{}) ++ran.pushing;
  }
  return ran;
}

int run_scenarios(const std::vector<std::string_view>& names, int ticks) {
  std::size_t found = 0;
  for (const Scenario& scenario : scenarios()) {
    if (!names.empty() && std::find(names.begin(), names.end(), scenario.name) == names.end()) {
      continue;
    }
    ++found;
    std::fprintf(stderr, "%s\n", scenario.name.c_str());  // shows where a violation is
    const auto session = scenario.make();
    const Ran ran = run_ticks(*session, ticks);
    std::printf("%-30s %7d ticks, %6d with force: nothing forbidden\n", scenario.name.c_str(),
                ran.ticks, ran.pushing);
    if (scenario.pushes && ran.pushing < ran.ticks / 20) {
      std::fprintf(stderr, "rt_proof: %s hardly pushes\n", scenario.name.c_str());
      return 1;
    }
  }
  if (found < std::max<std::size_t>(names.size(), 1)) {
    std::fprintf(stderr, "rt_proof: no such scenario (--list)\n");
    return 2;
  }
  return 0;
}

class PlantedSession final : public Session {
 public:
  Servo& servo() override { return *servo_; }
  void edit(int tick, std::int64_t) override {
    if (tick == warm_up_ticks()) servo_->publish(model_);
  }
  void set_model(const ForceModel& model) { model_ = model; }

 private:
  NullDevice device_;
  std::unique_ptr<Servo> servo_ = std::make_unique<Servo>(device_, ServoOptions{});
  ForceModel model_;
};

int run_bad_driver(std::string_view name) {
  const auto session = make_driver_session(
      [](std::vector<FaultWindow> faults) {
        return make_bad_bench(BadDriver::kAllocates, std::move(faults));
      },
      false);
  run_ticks(*session, 100);
  std::fprintf(stderr, "rt_proof: %s was NOT caught\n", name.data());
  return 1;
}

int run_plant(std::string_view name) {
  if (name == "driver_allocates") return run_bad_driver(name);
  for (const Plant& plant : plants()) {
    if (plant.name != name) continue;
    if (name == "raw_system_call" && !sees_raw_system_calls()) return 77;
    if (plant.prepare != nullptr) plant.prepare();
    PlantedSession session;
    session.set_model(ForceModel(Planted{plant.commit}));
    run_ticks(session, 100);
    std::fprintf(stderr, "rt_proof: the planted %s was NOT caught\n", name.data());
    return 1;
  }
  std::fprintf(stderr, "rt_proof: no such plant (--list-plants)\n");
  return 2;
}

int run(int argc, char** argv) {
  int ticks = 20000;
  std::vector<std::string_view> names;
  for (int i = 1; i < argc; ++i) {
    const std::string_view word = argv[i];
    if (word == "--list") {
      for (const Scenario& scenario : scenarios()) std::puts(scenario.name.c_str());
      return 0;
    }
    if (word == "--list-plants") {
      for (const Plant& plant : plants()) std::puts(plant.name.data());
      return 0;
    }
    if (word == "--plant" && i + 1 < argc) {
      install_watch();
      return run_plant(argv[i + 1]);
    }
    if (word == "--ticks" && i + 1 < argc) {
      ticks = std::atoi(argv[++i]);
    } else {
      names.push_back(word);
    }
  }
  install_watch();
  return run_scenarios(names, ticks);
}

}  // namespace
}  // namespace felt::rt_test

int main(int argc, char** argv) {
  return felt::rt_test::run(argc, argv);
}
