#pragma once

#include <optional>
#include <string_view>

#include "tests/devices/drivers/driver_bench.h"

namespace felt {

/// What a bench has opened, as the loop sees it: in the sheet's frame, each read() on the tick of
/// its time. Nothing open (a reconnect that failed) reads as kDisconnected.
class BenchDevice final : public Device {
 public:
  /// The bench must outlive this, and be open now.
  explicit BenchDevice(DriverBench& bench) : bench_(bench) { renew(); }

  /// After the bench has opened its device anew. Capabilities may be others then: a new loop.
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
  /// What the last read() failed with.
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
/// hand, with nothing of a driver between. It says what the driver says that it can, feels what the
/// device's axes can make it feel, and speaks of the pen as the device does.
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
