#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "felt/devices/openhaptics/hd_library.h"
#include "felt/devices/openhaptics/temperature_guard.h"
#include "felt/driver/driver.h"
#include "felt/driver/force_gate.h"
#include "felt/rt/latest_value.h"

namespace felt {

/// A device that is open in libHD. The library's scheduler runs its loop. The library allows
/// reading and writing only within a frame. Each tick has exactly one frame, from read() to
/// write(). The library's errors are checked twice per tick, after reading and after writing.
class OpenHapticsDevice final : public DriverDevice, private LoopHost {
 public:
  /// Takes ownership of the device `handle`. The destructor closes it and releases the library.
  OpenHapticsDevice(std::shared_ptr<HdLibrary> library, hd::Handle handle,
                    DeviceDescriptor descriptor);
  ~OpenHapticsDevice() override;

  // Device
  [[nodiscard]] std::string_view name() const noexcept override { return descriptor_.driver; }
  [[nodiscard]] const Capabilities& capabilities() const noexcept override {
    return descriptor_.capabilities;
  }
  tl::expected<PenSample, DeviceFault> read(std::int64_t now_ns) noexcept override;
  std::optional<Vec3> pen_axis() noexcept override { return axis_; }
  tl::expected<void, DeviceFault> write(const Force& force) noexcept override;
  void stop() noexcept override;
  [[nodiscard]] std::optional<Force> held_force() const noexcept override { return gate_.held(); }

  // DriverDevice
  [[nodiscard]] const DeviceDescriptor& descriptor() const noexcept override { return descriptor_; }
  [[nodiscard]] DeviceStatus status() noexcept override;
  [[nodiscard]] LoopHost* loop_host() noexcept override { return this; }
  [[nodiscard]] Homing homing() noexcept override;
  [[nodiscard]] std::string homing_words() override;
  Result<void> find_home() override;

  /// begin_tick() is called before the work of one tick and end_tick() after it, on the scheduler's
  /// thread: by the callback, or by a test that acts as the scheduler. If nothing was written in
  /// the frame, end_tick() ends the frame with zero force.
  void begin_tick() noexcept;
  void end_tick() noexcept;

 private:
  enum class Frame : std::uint8_t { kNotYet, kOpen, kDone };
  /// Sensors that not every device has.
  struct Senses {
    bool temperature = false;
    bool safety_switch = false;
    bool inkwell = false;
    bool rate = false;
    bool attitude = false;
  };

  Result<void> start_loop(Tick tick, void* context) override;
  void stop_loop() noexcept override;
  static unsigned serve(void* self);
  unsigned serve() noexcept;

  [[nodiscard]] Senses find_senses() const noexcept;
  tl::expected<PenSample, DeviceFault> sense(std::int64_t now_ns) noexcept;
  void sense_state() noexcept;
  void sense_attitude() noexcept;
  [[nodiscard]] Force bounded(const Force& asked, bool& was_finite) noexcept;
  void open_frame() noexcept;
  void close_frame(const Force& force) noexcept;
  std::optional<DeviceFault> drain() noexcept;
  void release() noexcept;
  void die() noexcept;
  void note(DeviceFault fault, std::string_view words, std::int64_t code) noexcept;
  tl::unexpected<DeviceFault> refuse(DeviceFault fault, std::string_view words) noexcept;
  void publish() noexcept { statuses_.publish(status_); }
  [[nodiscard]] hd::Enum style() const noexcept;

  std::shared_ptr<HdLibrary> library_;
  const HdFunctions& call_;
  hd::Handle handle_;
  DeviceDescriptor descriptor_;
  Senses senses_;

  // These are used by the scheduler's thread, or by the thread that acts as the scheduler.
  ForceGate gate_;
  TemperatureGuard warmth_;
  bool tick_is_open_ = false;
  Frame frame_ = Frame::kNotYet;
  std::int64_t now_ns_ = 0;
  std::uint64_t ticks_ = 0;
  tl::expected<PenSample, DeviceFault> last_ = tl::unexpected(DeviceFault::kOther);
  std::optional<Vec3> axis_;                // axis of the stylus, in the maker's axes
  std::optional<DeviceFault> force_fault_;  // found while reading; reported by write()
  bool is_gone_ = false;
  bool is_output_on_ = false;
  bool has_safety_switch_ = false;  // the switch was closed at least once
  bool is_held_ = true;             // the user holds the stylus, according to the safety switch
  bool is_in_inkwell_ = false;
  bool is_home_ = true;
  DeviceStatus status_;
  LatestValue<DeviceStatus> statuses_;

  // The loop.
  Tick tick_ = nullptr;
  void* context_ = nullptr;
  hd::CallbackHandle callback_ = 0;
  bool loop_runs_ = false;  // used on the edit thread
  std::atomic<bool> is_serving_{false};
  std::atomic<bool> is_in_callback_{false};
  bool is_greeted_ = false;  // the locale of the scheduler's thread is set
};

}  // namespace felt
