#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <memory>
#include <thread>

#include "felt/devices/evdev/effect_keeper.h"
#include "felt/devices/evdev/evdev_driver.h"
#include "felt/devices/evdev/known_sticks.h"
#include "felt/driver/force_gate.h"

namespace felt {

/// Returns the capabilities of a stick of this kind.
Capabilities capabilities_of(const StickKind& kind, double step_mm) noexcept;

/// An open stick or wheel. Every 8 milliseconds, fit_axis() fits a force law of position and
/// velocity to the last forces that write() received, and plan_effects() converts this law to
/// effects.
///
/// The haptic thread never waits for the kernel: read() reads events that have already arrived;
/// write() and stop() post requests to the worker thread (effect_keeper.h), which checks for
/// requests every millisecond. So after stop() the force ends within about 1 ms plus the time of
/// the transfer in progress. If the worker is blocked, the force ends after kEffectMs at the
/// latest, because effects end by themselves.
class StickDevice final : public DriverDevice, public EffectServed {
 public:
  /// Requires an open port whose axes have been read. Starts the thread.
  StickDevice(std::unique_ptr<EvdevPort> port, const StickKind& kind, const StickAxes& axes,
              DeviceDescriptor descriptor, bool has_thread);
  ~StickDevice() override;

  [[nodiscard]] std::string_view name() const noexcept override { return "evdev"; }
  [[nodiscard]] const Capabilities& capabilities() const noexcept override {
    return descriptor_.capabilities;
  }
  [[nodiscard]] const DeviceDescriptor& descriptor() const noexcept override { return descriptor_; }
  [[nodiscard]] DeviceStatus status() noexcept override;
  tl::expected<PenSample, DeviceFault> read(std::int64_t now_ns) noexcept override;
  tl::expected<void, DeviceFault> write(const Force& force) noexcept override;
  void stop() noexcept override;
  [[nodiscard]] std::optional<Force> held_force() const noexcept override { return gate_.held(); }
  [[nodiscard]] bool is_arm() const noexcept override { return false; }
  void serve(std::int64_t now_ns) noexcept override;

 private:
  static constexpr std::size_t kWindow = 24;  ///< samples used in a fit

  /// The state of the axes as the worker has read it, and the serial number of the request
  /// (`questions_`) that it answers.
  struct Answer {
    std::uint32_t question = 0;
    StickStand stand;
  };

  void run() noexcept;
  tl::expected<void, int> receive(std::int64_t now_ns) noexcept;
  void release() noexcept;
  void remember(const Force& force) noexcept;
  void plan() noexcept;
  tl::unexpected<DeviceFault> failed(DeviceFault fault, int error) noexcept;

  std::unique_ptr<EvdevPort> port_;
  StickKind kind_;
  StickAxes axes_;
  DeviceDescriptor descriptor_;
  ForceGate gate_;
  EffectKeeper keeper_;
  // Used by the haptic thread only.
  std::int64_t now_ns_ = 0;
  bool has_asked_ = false;
  PenSample pen_;
  std::array<FitSample, kWindow> x_{}, y_{};
  std::size_t count_ = 0;
  std::int64_t planned_ns_ = 0;
  bool is_gone_ = false;
  DeviceStatus status_;
  LatestValue<DeviceStatus> statuses_;
  std::atomic<std::uint32_t> questions_{0};  // number of requests for the axes' state
  LatestValue<Answer> answers_;
  std::uint32_t answered_ = 0;  // used by the worker
  std::atomic<bool> is_over_{false};
  std::thread thread_;
};

}  // namespace felt
