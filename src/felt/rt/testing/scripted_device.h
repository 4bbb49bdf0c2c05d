#pragma once

#include <chrono>
#include <optional>
#include <string_view>
#include <thread>

#include "felt/rt/device.h"

namespace felt {

/// A device for tests that returns the sample or fault that a test sets, and counts calls.
class ScriptedDevice final : public Device {
 public:
  ScriptedDevice() {
    abilities.max_force_n = 10.0;
    abilities.continuous_force_n = 10.0;
    abilities.max_stiffness_n_per_m = 2000.0;
    abilities.max_damping_n_s_per_m = 10.0;
  }

  [[nodiscard]] std::string_view name() const noexcept override { return "scripted"; }
  [[nodiscard]] const Capabilities& capabilities() const noexcept override { return abilities; }
  tl::expected<PenSample, DeviceFault> read(std::int64_t now_ns) noexcept override {
    if (read_fault) return tl::unexpected(*read_fault);
    sample.time_ns = now_ns;
    return sample;
  }
  tl::expected<void, DeviceFault> write(const Force& asked) noexcept override {
    if (write_fault) return tl::unexpected(*write_fault);
    force = asked;
    ++writes;
    return {};
  }
  [[nodiscard]] std::optional<Force> held_force() const noexcept override { return holds; }
  [[nodiscard]] bool is_arm() const noexcept override { return has_arm; }
  std::optional<Vec3> pen_axis() noexcept override { return axis; }
  void stop() noexcept override {
    force = {};
    ++stops;
  }

  PenSample sample{0, {0.0, 0.0, 1.0}, {}, {}, 0};
  std::optional<Vec3> axis;
  std::optional<DeviceFault> read_fault;
  std::optional<DeviceFault> write_fault;
  Force force;                 ///< the last requested force
  std::optional<Force> holds;  ///< returned by held_force()
  bool has_arm = false;        ///< set it before the servo is made
  int writes = 0;
  int stops = 0;
  Capabilities abilities;
};

/// Waits for `condition` without a time limit. Only the limit of the test applies.
template <class Condition>
void wait_until(Condition condition) {
  while (!condition()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
}

}  // namespace felt
