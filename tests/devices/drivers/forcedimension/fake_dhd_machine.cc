#include "tests/devices/drivers/forcedimension/fake_dhd_machine.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <mutex>
#include <string>

namespace felt::fake_dhd {
namespace {

constexpr int kMax = 64;
constexpr std::int64_t kTimeGuardNs = 100'000;  // a guess, because the vendor does not document it
constexpr std::int64_t kWatchdogNs = 125'000;   // unit

#if defined(__GNUC__)
__attribute__((tls_model("initial-exec")))
#endif
thread_local int last_error = 0;

std::array<Device, kMax> devices;
std::mutex plugging;
std::vector<int> plugged;  // in the order of plugging in
// True while the device answers. Atomic, because one thread counts devices while another reads one.
std::array<std::atomic<bool>, kMax> answers{};
std::atomic<int> expert{0};
unsigned short last_serial = 999;

}  // namespace

int failed(int error) noexcept {
  last_error = error;
  return -1;
}

int newest_error() noexcept {
  return last_error;
}

void break_rule(Device& d, const char* rule, const char* function) {
  if (d.state.broken_rule.empty()) d.state.broken_rule = std::string(function) + rule;
}

Device* device_of(char id, const char* function) {
  const int number = id;
  if (number < 0 || number >= kMax) {
    for (Device& d : devices) {
      if (d.port != nullptr) break_rule(d, " without the number of a device", function);
    }
    failed(kInvalidIndex);
    return nullptr;
  }
  Device& d = devices[static_cast<std::size_t>(number)];
  if (!d.state.is_open) {
    break_rule(d, " for a device that is not open", function);
    failed(kNoDevice);
    return nullptr;
  }
  if (d.port == nullptr) {
    failed(kComError);
    return nullptr;
  }
  return &d;
}

void switch_off(Device& d, int cause) noexcept {
  if (d.state.mode == State::Mode::kForce && d.port != nullptr) d.port->release();
  if (d.state.mode != State::Mode::kReset) d.state.mode = State::Mode::kBrake;
  d.state.cause = d.state.person_has_forces ? 1 : cause;
}

void look(Device& d) noexcept {
  if (d.port == nullptr) return;
  const std::int64_t now = d.port->now_ns();
  d.fed_ns = std::min(d.fed_ns, now);  // the clock was set back
  const Port::Sense& sense = d.port->sense();
  if (!sense.is_home && d.state.is_home) {
    d.port->release();
    d.state.is_home = false;
    d.state.mode = State::Mode::kReset;
  }
  if (sense.error == kComError) switch_off(d, 5);
  if (d.state.mode != State::Mode::kForce || d.state.is_regulated) return;
  if (d.state.watchdog != 0 && now - d.fed_ns > d.state.watchdog * kWatchdogNs) switch_off(d, 3);
  if (sense.speed_m_per_s > d.model.guard_m_per_s) switch_off(d, 2);
}

int ask(Device& d) noexcept {
  look(d);
  const Port::Sense& sense = d.port->sense();
  if (sense.error != 0) return failed(sense.error);
  const std::int64_t now = d.port->now_ns();
  if (d.has_said && now >= d.said_ns && now - d.said_ns < kTimeGuardNs) return 1;
  d.has_said = true;
  d.said = sense;
  d.said_ns = now;
  return 0;
}

int command(Device& d, const std::array<double, 3>& f) noexcept {
  look(d);
  const double size = std::hypot(f[0], f[1], f[2]);
  if (!std::isfinite(f[0]) || !std::isfinite(f[1]) || !std::isfinite(f[2])) {
    d.state.largest_asked_n = std::numeric_limits<double>::infinity();
    break_rule(d, "a force that is no number");
    return failed(kInvalid);
  }
  d.state.largest_asked_n = std::max(d.state.largest_asked_n, size);
  if (d.state.is_regulated) break_rule(d, "a force while the library moves the arm");
  if (d.state.was_reported_lost && size > 0.0) break_rule(d, "a force before it knows where it is");
  if (const int error = d.port->sense().error; error != 0) return failed(error);
  d.fed_ns = d.port->now_ns();
  d.asked = f;
  const bool may_come_back = d.state.taken_by_world && d.state.mode == State::Mode::kBrake;
  if (d.state.mode != State::Mode::kForce && !may_come_back) return 0;
  const int answer = d.port->push(f);
  if (answer == Port::kTaken) {
    d.state.taken_by_world = true;
    d.state.person_has_forces = true;
    switch_off(d, 1);
    return 0;
  }
  if (answer != 0) return failed(answer);
  if (may_come_back) {
    d.state.taken_by_world = false;
    d.state.person_has_forces = false;
    d.state.mode = State::Mode::kForce;
    d.state.cause = 0;
  }
  return size > d.model.saturates_above_n ? 2 : 0;
}

bool needs_expert_mode(Device& d, const char* function) {
  if (expert.load() > 0) return false;
  break_rule(d, " without the expert mode", function);
  failed(kExpertMode);
  return true;
}

void change_expert_mode(int by) noexcept {
  expert.fetch_add(by);
}

namespace {

class TheBench final : public Bench {
 public:
  int plug(const Model& model, Port& port) override {
    const std::lock_guard guard(plugging);
    for (int i = 0; i < kMax; ++i) {
      Device& d = devices[static_cast<std::size_t>(i)];
      if (d.port != nullptr || d.state.is_open) continue;
      d = Device();
      d.model = model;
      d.port = &port;
      d.serial = ++last_serial;
      d.state.is_home = model.is_home;
      d.state.mode = model.is_home ? State::Mode::kIdle : State::Mode::kReset;
      d.state.gripper_n = std::numeric_limits<double>::quiet_NaN();
      answers[static_cast<std::size_t>(i)] = true;
      plugged.push_back(i);
      return i;
    }
    return -1;
  }
  void unplug(int number) noexcept override {
    const std::lock_guard guard(plugging);
    devices[static_cast<std::size_t>(number)].port = nullptr;
    std::erase(plugged, number);
  }
  void tick(int number) noexcept override {
    Device& d = devices[static_cast<std::size_t>(number)];
    answers[static_cast<std::size_t>(number)] = d.port->sense().error != kComError;
    look(d);
    // The user moved the device to its rest pose.
    if (d.model.is_home && d.port->sense().is_home && !d.state.is_home) {
      d.state.is_home = true;
      d.state.mode = State::Mode::kBrake;
    }
  }
  void press_force_button(int number) noexcept override {
    Device& d = devices[static_cast<std::size_t>(number)];
    if (!d.state.person_has_forces) {
      d.state.person_has_forces = true;
      switch_off(d, 1);
    } else if (d.state.mode == State::Mode::kBrake) {
      d.state.person_has_forces = false;
      d.state.mode = State::Mode::kForce;
      d.state.cause = 0;
      d.port->push(d.asked);  // the newest command
    }
  }
  State& state(int number) noexcept override {
    return devices[static_cast<std::size_t>(number)].state;
  }
  [[nodiscard]] unsigned short serial(int number) const noexcept override {
    return devices[static_cast<std::size_t>(number)].serial;
  }
};

TheBench bench;

}  // namespace

Bench& the_bench() noexcept {
  return bench;
}

std::vector<int> listed() {
  const std::lock_guard guard(plugging);
  std::vector<int> found = plugged;
  std::erase_if(found, [](int i) { return !answers[static_cast<std::size_t>(i)]; });
  return found;
}

int open_index(char index) {
  const std::vector<int> found = listed();
  if (index < 0 || static_cast<std::size_t>(index) >= found.size()) return failed(kNoDevice);
  Device& d = devices[static_cast<std::size_t>(found[static_cast<std::size_t>(index)])];
  if (d.state.is_open_elsewhere) return failed(kInUse);
  if (!d.state.is_open) {
    d.state.is_open = true;
    ++d.state.opens;
  }
  return found[static_cast<std::size_t>(index)];
}

int close_device(char id, const char* function) {
  const int number = id;
  if (number < 0 || number >= kMax || !devices[static_cast<std::size_t>(number)].state.is_open) {
    return failed(kNoDevice);
  }
  Device& d = devices[static_cast<std::size_t>(number)];
  if (d.state.mode == State::Mode::kForce) break_rule(d, " while its forces were on", function);
  if (d.state.is_regulated) break_rule(d, " while the library moves the arm", function);
  if (expert.load() > 0) break_rule(d, " in the expert mode", function);
  d.state.is_open = false;
  return 0;
}

}  // namespace felt::fake_dhd
