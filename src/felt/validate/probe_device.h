#pragma once

#include <atomic>
#include <cstdint>
#include <optional>

#include "felt/rt/device.h"
#include "felt/rt/latest_value.h"
#include "felt/rt/spsc_ring.h"

namespace felt {

/// The data that was read from and written to a device at one tick.
struct ProbeTick {
  std::int64_t now_ns = 0;
  PenSample sample;  ///< the sample as read; the last good one if reading failed
  std::optional<DeviceFault> read_fault;   ///< reason why reading failed
  Force force;                             ///< the force as written
  std::optional<DeviceFault> write_fault;  ///< reason why writing failed
  bool after_stall = false;                ///< a stall (stall()) preceded this read
};

/// Sits between the safety chain and a device under test. It records every tick, and sets the force
/// to zero permanently if the pen leaves a given ball (guard()). The probe never adds force. It is
/// real-time safe if the device under test is real-time safe.
class ProbeDevice final : public Device {
 public:
  static constexpr std::size_t kRingTicks = 8192;
  using Ring = SpscRing<ProbeTick, kRingTicks>;

  /// `device` must outlive this object.
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
  /// Sets the ball that the pen must not leave, from the next tick on.
  void guard(const Vec3& middle_mm, double radius_mm) noexcept;
  /// Returns true if the pen has left the ball. The force has been zero since.
  [[nodiscard]] bool has_tripped() const noexcept { return tripped_.load(); }
  /// Makes the next read() sleep for `for_ns` before it reads, which simulates a program that
  /// hangs. Applies to one read() only.
  void stall(std::int64_t for_ns) noexcept { stall_ns_.store(for_ns); }
  /// Marks the next tick as the first after a stall, for a loop that does the waiting itself.
  void note_stall() noexcept { stall_ns_.store(0); }
  [[nodiscard]] Ring& ticks() noexcept { return ring_; }

 private:
  struct Ball {
    Vec3 middle;
    double radius_mm = 0.0;  // 0 = there is no ball
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
