#pragma once

#include <optional>
#include <string_view>

#include "tests/devices/drivers/driver_bench.h"

namespace felt {

/// The device that a bench has opened, in the frame of the surface, as the haptic loop uses it.
/// Each read() belongs to the tick of its time. It fails with kDisconnected if no device is open
/// because a reconnect failed.
class BenchDevice final : public Device {
 public:
  /// Requires that the bench outlives this object and that its device is open.
  explicit BenchDevice(DriverBench& bench) : bench_(bench) { renew(); }

  /// Call this after the bench has reopened its device. The capabilities may have changed, so a new
  /// loop is needed.
  void renew() {
    device_.reset();
    unread_.reset();
    if (bench_.device() == nullptr) {
      unread_ = DeviceFault::kDisconnected;
      return;
    }
    device_.emplace(*bench_.device(), bench_.plane());
    capabilities_ = device_->capabilities();
  }

  [[nodiscard]] std::string_view name() const noexcept override { return bench_.name(); }
  [[nodiscard]] const Capabilities& capabilities() const noexcept override { return capabilities_; }
  tl::expected<PenSample, DeviceFault> read(std::int64_t now_ns) noexcept override {
    bench_.before_tick(now_ns);
    if (!device_) return tl::unexpected(DeviceFault::kDisconnected);
    auto sample = device_->read(now_ns);
    unread_ = sample ? std::nullopt : std::optional(sample.error());
    return sample;
  }
  /// Returns the error of the last read(), if it failed.
  [[nodiscard]] std::optional<DeviceFault> unread() const noexcept { return unread_; }
  std::optional<PenSample> between() noexcept override {
    return device_ ? device_->between() : std::nullopt;
  }
  tl::expected<void, DeviceFault> write(const Force& force) noexcept override {
    if (!device_) return tl::unexpected(DeviceFault::kDisconnected);
    return device_->write(force);
  }
  [[nodiscard]] std::optional<Force> held_force() const noexcept override {
    return device_ ? device_->held_force() : std::nullopt;
  }
  [[nodiscard]] bool is_arm() const noexcept override { return device_ && device_->is_arm(); }
  void stop() noexcept override {
    if (device_) device_->stop();
  }

 private:
  DriverBench& bench_;
  std::optional<OpenDevice> device_;
  std::optional<DeviceFault> unread_;
  Capabilities capabilities_;
};

/// The plain simulated device that a bench's ink is compared with: the same stylus in the same
/// hand, without a driver in between. It has the same capabilities as the driver's device, applies
/// forces only along the axes with motors, and reports the pen as that device does.
class PlainDevice final : public Device {
 public:
  PlainDevice(const DriverBench& bench, const StylusPreset& preset,
              const Capabilities& capabilities)
      : bench_(bench), stylus_(preset), capabilities_(capabilities) {}

  [[nodiscard]] SimulatedStylus& stylus() noexcept { return stylus_; }

  [[nodiscard]] std::string_view name() const noexcept override { return "plain"; }
  [[nodiscard]] const Capabilities& capabilities() const noexcept override { return capabilities_; }
  tl::expected<PenSample, DeviceFault> read(std::int64_t now_ns) noexcept override {
    auto sample = stylus_.read(now_ns);
    if (sample) *sample = bench_.as_said(*sample);
    return sample;
  }
  tl::expected<void, DeviceFault> write(const Force& force) noexcept override {
    return stylus_.write(capabilities_.actuated_axes > 2 ? force : Force{force.x, force.y, 0.0});
  }
  void stop() noexcept override { stylus_.stop(); }

 private:
  const DriverBench& bench_;
  SimulatedStylus stylus_;
  Capabilities capabilities_;
};

}  // namespace felt
