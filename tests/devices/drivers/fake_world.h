#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "felt/devices/simulated/faulty_device.h"
#include "felt/devices/simulated/simulated_stylus.h"

namespace felt {

/// Records the force that the motors hold, regardless of who requested it. Sits between the stylus
/// and the layers above it that may fail.
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

/// The world behind a fake: a simulated stylus in a simulated hand, which may fail on schedule. The
/// fake reads the pen from it in the frame of the surface. It converts the sample into the frame,
/// units and messages of the vendor's library, service or board, and returns the requested force.
///
/// A fake forwards every command that releases the motors (a force of zero, a stop command, the
/// brakes, a watchdog, a frame without a force, closing) as a write of zero or a stop() here.
class FakeWorld {
 public:
  /// Takes the capabilities of the faked device, and the mechanics of the nearest preset.
  explicit FakeWorld(const StylusPreset& preset, std::vector<FaultWindow> faults = {})
      : preset_(preset), stylus_(preset), motors_(stylus_), faulty_(motors_, std::move(faults)) {}

  [[nodiscard]] const StylusPreset& preset() const noexcept { return preset_; }
  [[nodiscard]] SimulatedStylus& stylus() noexcept { return stylus_; }
  /// Returns the device that the fake reads and writes.
  [[nodiscard]] FaultyDevice& device() noexcept { return faulty_; }
  /// Returns the force that the motors hold now, in the frame of the surface, in N.
  [[nodiscard]] const Force& held_force() const noexcept { return motors_.held(); }
  /// Returns the largest force that the motors have held so far, in N.
  [[nodiscard]] double largest_held_n() const noexcept { return motors_.largest_n(); }

 private:
  StylusPreset preset_;
  SimulatedStylus stylus_;
  MotorWatch motors_;
  FaultyDevice faulty_;
};

}  // namespace felt
