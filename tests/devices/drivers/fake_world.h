#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "felt/devices/simulated/faulty_device.h"
#include "felt/devices/simulated/simulated_stylus.h"

namespace felt {

/// Looks on, where the wires of the motors would be: what force they hold now, whoever asked for
/// it. Between the stylus and what may fail above it.
class MotorWatch final : public Device {
 public:
  explicit MotorWatch(Device& motors) noexcept : motors_(motors) {}

  [[nodiscard]] std::string_view name() const noexcept override { return motors_.name(); }
  [[nodiscard]] const Capabilities& capabilities() const noexcept override {
    return motors_.capabilities();
  }
  tl::expected<PenSample, DeviceFault> read(std::int64_t now_ns) noexcept override {
    return motors_.read(now_ns);
  }
  tl::expected<void, DeviceFault> write(const Force& force) noexcept override {
    auto done = motors_.write(force);
    held_ = done ? force : Force{};
    largest_n_ = std::max(largest_n_, norm(held_));
    return done;
  }
  void stop() noexcept override {
    motors_.stop();
    held_ = {};
  }

  [[nodiscard]] const Force& held() const noexcept { return held_; }
  [[nodiscard]] double largest_n() const noexcept { return largest_n_; }

 private:
  Device& motors_;
  Force held_;
  double largest_n_ = 0.0;
};

/// What stands behind a fake of the other side: a simulated stylus in a simulated hand, which may
/// fail on schedule. The fake asks it for the pen (in the sheet's frame), turns that into what the
/// vendor's library, service or board would say in its own frame, units and words, and hands back
/// the force that was asked of it.
///
/// A fake hands on every way there is to let go of the motors (a force of zero, a stop command, the
/// brakes, a watchdog, a frame without a force, closing) as a write of zero or a stop() here.
class FakeWorld {
 public:
  /// The figures of the device that is to be faked; its mechanics from the nearest preset.
  explicit FakeWorld(const StylusPreset& preset, std::vector<FaultWindow> faults = {})
      : preset_(preset), stylus_(preset), motors_(stylus_), faulty_(motors_, std::move(faults)) {}

  [[nodiscard]] const StylusPreset& preset() const noexcept { return preset_; }
  [[nodiscard]] SimulatedStylus& stylus() noexcept { return stylus_; }
  /// What the fake reads and writes.
  [[nodiscard]] FaultyDevice& device() noexcept { return faulty_; }
  /// The force that the motors hold now, in the sheet's frame, N; and the largest so far.
  [[nodiscard]] const Force& held_force() const noexcept { return motors_.held(); }
  [[nodiscard]] double largest_held_n() const noexcept { return motors_.largest_n(); }

 private:
  StylusPreset preset_;
  SimulatedStylus stylus_;
  MotorWatch motors_;
  FaultyDevice faulty_;
};

}  // namespace felt
