#include "tests/devices/drivers/openhaptics/fake_machine.h"

#include <pthread.h>
#include <sched.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "felt/rt/device.h"

namespace felt::fake_libhd {
namespace {

constexpr double kThermalS = 60.0;  // of the motors' warming

void warm_up(double dt_s) {
  Fake& f = fake();
  const double share = f.held_n / std::max(f.model->continuous_force_n, 1e-6);
  f.temperature += std::min(dt_s / kThermalS, 1.0) * (share * share - f.temperature);
  if (f.temperature >= 1.0) f.is_warm = true;
  if (f.temperature < 0.95) f.is_warm = false;
}

double length(const std::array<double, 3>& v) {
  return std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
}

}  // namespace

Fake& fake() {
  static Fake the_one;
  return the_one;
}

// Converts a fault of the world to the vendor's error.
hd::Enum error_of(int result) {
  switch (static_cast<DeviceFault>(result - 1)) {
    case DeviceFault::kDisconnected:
      return error::kCommunication;
    case DeviceFault::kForcesOff:
      return error::kTooFast;
    case DeviceFault::kOverheated:
      return error::kWarmMotors;
    default:
      return error::kDeviceFault;
  }
}

void push(hd::Enum code, int internal) {
  Fake& f = fake();
  if (f.error_count == kMaxErrors) return;
  f.errors[f.error_count++] = {code, internal, f.open > 0 ? kHandle : hd::kNoHandle};
}

void broken(const char* rule, hd::Enum code) {
  if (*fake().rule == '\0') fake().rule = rule;
  if (code != 0) push(code);
}

bool has(hd::Enum what) {
  for (const auto& [known, on] : fake().capabilities) {
    if (known == what) return on;
  }
  return false;
}

void start_capabilities() {
  fake().capabilities = {
      {capability::kForceOutput, false},        {capability::kMaxForceClamping, true},
      {capability::kForceRamping, true},        {capability::kSoftwareForceLimit, true},
      {capability::kOneFrameLimit, true},       {parameter::kSoftwareVelocityLimit, true},
      {parameter::kSoftwareImpulseLimit, false}};  // a program switched it off
}

bool is_in_tick() {
  const Fake& f = fake();
  return f.tick_is_open && (!f.uses_thread || f.servo == std::this_thread::get_id());
}

void release() {
  Fake& f = fake();
  f.held_n = 0.0;
  if (f.world.stop != nullptr) f.world.stop(f.world.context);
}

void open_tick(std::int64_t now_ns) {
  Fake& f = fake();
  f.last_ns = f.now_ns;
  f.now_ns = now_ns;
  f.tick_is_open = true;
  f.frame_was = false;
  f.servo = std::this_thread::get_id();
  if (f.open == 0) return;
  warm_up(std::clamp(1e-9 * static_cast<double>(f.now_ns - f.last_ns), 0.0, 1.0));
  f.read_result = f.world.read(f.world.context, now_ns, &f.read_pen);
  f.calibration_lost = f.read_result == 1 + static_cast<int>(DeviceFault::kNotCalibrated);
}

void close_tick() {
  Fake& f = fake();
  if (f.frame_is_open) {
    broken("a frame was left open at the end of a tick", error::kFrameError);
    f.frame_is_open = false;
  }
  f.tick_is_open = false;
}

void step(std::int64_t now_ns) {
  Fake& f = fake();
  std::array<Scheduled, kMaxCallbacks> due{};
  std::size_t count = 0;
  {
    const Guard guard;
    if (!f.is_running) return;
    open_tick(now_ns);
    for (const Scheduled& callback : f.callbacks) due[count++] = callback;
  }
  for (std::size_t i = 0; i < count; ++i) {
    if (due[i].call(due[i].data) == hd::kCallbackContinue) continue;
    const Guard guard;
    std::erase_if(f.callbacks, [&](const Scheduled& c) { return c.handle == due[i].handle; });
  }
  const Guard guard;
  close_tick();
}

void run_thread() {
  using Clock = std::chrono::steady_clock;
  // The vendor's library probably does the same, if the system permits it.
  const sched_param wanted{.sched_priority = 80};
  static_cast<void>(pthread_setschedparam(pthread_self(), SCHED_FIFO, &wanted));
  const auto start = Clock::now();
  auto next = start;
  while (!fake().stop_thread.load()) {
    next += std::chrono::nanoseconds(1'000'000'000 / std::max(fake().model->rate_hz, 1));
    std::this_thread::sleep_until(next);
    step(std::chrono::nanoseconds(Clock::now() - start).count());
  }
}

void stop_running() {
  Fake& f = fake();
  {
    const Guard guard;
    f.is_running = false;
  }
  f.stop_thread.store(true);
  if (f.thread.joinable()) f.thread.join();
  release();
}

void plug_in_own() {
  Fake& f = fake();
  if (f.model || !f.uses_thread) return;
  f.own_world = make_standalone_world();
  f.model = f.own_world->model();
  f.world = f.own_world->world();
}

void send() {
  Fake& f = fake();
  double size = length(f.asked);
  if (!std::isfinite(size)) {
    f.largest_n = HUGE_VAL;
    broken("a force that is no number", error::kInvalidValue);
    return release();
  }
  f.largest_n = std::max(f.largest_n, size);
  std::array<double, 3> force = f.asked;
  if (!has(capability::kForceOutput)) force = {};
  if (size > f.model->max_force_n) {
    if (!has(capability::kMaxForceClamping)) {
      push(error::kTooMuchForce);
      return release();
    }
    for (double& part : force) part *= f.model->max_force_n / size;
  }
  if (f.is_warm) {
    push(error::kWarmMotors);
    return release();
  }
  f.held_n = length(force);
  const int result = f.world.write(f.world.context, force.data());
  if (result == 0) return;
  push(error_of(result), result);
  f.held_n = 0.0;
}

void reset() {
  Fake& f = fake();
  if (f.thread.joinable()) {
    f.stop_thread.store(true);
    f.thread.join();
  }
  f.model.reset();
  f.world = {};
  f.own_world.reset();
  f.is_occupied = false;
  f.safety_switch = true;
  f.inkwell = f.at_rest = false;
  f.is_home = true;
  f.calibration_lost = f.is_warm = false;
  f.temperature = 0.0;
  f.refusal = 0;
  f.calls_while_stopping = false;
  f.open = 0;
  f.is_running = false;
  f.error_count = 0;
  f.callbacks.clear();
  f.now_ns = f.last_ns = 0;
  f.tick_is_open = f.frame_is_open = f.frame_was = false;
  f.read_result = 0;
  f.frame = {};
  f.asked = {};
  f.held_n = f.largest_n = 0.0;
  f.rule = "";
  f.frames = 0;
  f.uses_thread = false;
  start_capabilities();
}

}  // namespace felt::fake_libhd
