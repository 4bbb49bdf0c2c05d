#pragma once

#include <atomic>
#include <cstdint>
#include <optional>

#include "felt/rt/device.h"
#include "felt/rt/latest_value.h"
#include "felt/rt/spsc_ring.h"

namespace felt {

/// What went through a device at one tick.
struct ProbeTick {
  std::int64_t now_ns = 0;
  PenSample sample;                        ///< as read; the last good one where reading failed
  std::optional<DeviceFault> read_fault;   ///< why it could not be read
  Force force;                             ///< as written
  std::optional<DeviceFault> write_fault;  ///< why it was not taken
  bool after_stall = false;                ///< nobody spoke to the device before this read
};

/// Stands between the safety chain and a device under test: notes every tick, and takes the force
/// away for good when the pen leaves a ball around where it was held. It never adds any. Real-time
/// safe as the device is.
class ProbeDevice final : public Device {
 public:
  static constexpr std::size_t kRingTicks = 8192;
  using Ring = SpscRing<ProbeTick, kRingTicks>;

  /// `device` must outlive this.
  explicit ProbeDevice(Device& device) noexcept : device_(device) {}

  [[nodiscard]] std::string_view name() const noexcept override { return device_.name(); }
  [[nodiscard]] const Capabilities& capabilities() const noexcept override {
    return device_.capabilities();
  }
  tl::expected<PenSample, DeviceFault> read(std::int64_t now_ns) noexcept override;
  tl::expected<void, DeviceFault> write(const Force& force) noexcept override;
  [[nodiscard]] std::optional<Force> held_force() const noexcept override {
    return device_.held_force();
  }
  [[nodiscard]] bool is_arm() const noexcept override { return device_.is_arm(); }
  void stop() noexcept override { device_.stop(); }

  // Edit thread.
  /// The ball that the pen must not leave; from the next tick on.
  void guard(const Vec3& middle_mm, double radius_mm) noexcept;
  /// It left the ball: no force since.
  [[nodiscard]] bool has_tripped() const noexcept { return tripped_.load(); }
  /// The next read() is the first that happens for so long: the loop sleeps there, as one that
  /// hangs would. Once.
  void stall(std::int64_t for_ns) noexcept { stall_ns_.store(for_ns); }
  /// The same where the loop does the waiting: the next tick is noted as the first after it.
  void note_stall() noexcept { stall_ns_.store(0); }
  [[nodiscard]] Ring& ticks() noexcept { return ring_; }

 private:
  struct Ball {
    Vec3 middle;
    double radius_mm = 0.0;  // 0 = none
  };
  static constexpr std::int64_t kNoStall = -1;

  Device& device_;
  LatestValue<Ball> balls_;
  std::atomic<bool> tripped_{false};
  std::atomic<std::int64_t> stall_ns_{kNoStall};
  ProbeTick tick_;
  Ring ring_;
};

}  // namespace felt
