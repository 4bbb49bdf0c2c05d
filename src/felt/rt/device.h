#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <tl/expected.hpp>

#include "felt/base/result.h"
#include "felt/geometry/vec3.h"
#include "felt/haptics/capabilities.h"
#include "felt/haptics/force.h"
#include "felt/haptics/pen_sample.h"

namespace felt {

/// The reason why a device could not be read or written. It is an enumeration because the haptic
/// thread must not allocate strings. `describe` returns a sentence; drivers keep the vendor's own
/// message for the edit thread.
enum class DeviceFault : std::uint8_t {
  kDisconnected,
  kNotCalibrated,
  kForcesOff,  ///< forces were disabled by a button, a velocity guard or a watchdog of the device
  kOverheated,
  kBadData,  ///< it reported invalid data
  kOther,
};

/// Returns one sentence for the user.
std::string_view describe(DeviceFault fault) noexcept;

/// A force-feedback stylus that a driver operates, or a replacement for it (R55), such as the
/// simulated stylus or a recording.
///
/// read(), write() and stop() are called on the haptic thread only, each at most once per tick and
/// in this order. They must not allocate, throw, or block beyond the device's own transfer.
/// Positions and forces are in the frame of the surface; a driver converts to and from this frame.
class Device {
 public:
  Device() = default;
  Device(const Device&) = delete;
  Device& operator=(const Device&) = delete;
  virtual ~Device() = default;

  /// Returns a short name for the user and for `--device`.
  [[nodiscard]] virtual std::string_view name() const noexcept = 0;
  /// Returns the capabilities of the device. They do not change while the device is open. Safe to
  /// call from any thread.
  [[nodiscard]] virtual const Capabilities& capabilities() const noexcept = 0;
  /// Returns the current state of the pen. If no newer sample has arrived since the last read(),
  /// returns the same sample again with the same time_ns, so that code that measures speeds can
  /// distinguish this from a pen that stands still. `now_ns` is the time of the loop's clock; a
  /// simulated device advances to it.
  virtual tl::expected<PenSample, DeviceFault> read(std::int64_t now_ns) noexcept = 0;
  /// Returns the next of the samples that arrived between the last two calls of read(), oldest
  /// first; nullopt if none is left. The function is for pens without motors that report faster
  /// than the loop runs. No force depends on these samples. Haptic thread only, after read().
  virtual std::optional<PenSample> between() noexcept { return std::nullopt; }
  /// Returns a vector along the pen as of the last read(), of any length, in the frame of the
  /// device's positions; nullopt if the device does not sense the direction. The function is for
  /// drivers that know the orientation of the pen but not that of the surface. OpenDevice knows the
  /// surface and computes PenSample::tilt_deg from the vector. Haptic thread only, after read().
  virtual std::optional<Vec3> pen_axis() noexcept { return std::nullopt; }
  /// Requests a force, which the device holds until the next write().
  virtual tl::expected<void, DeviceFault> write(const Force& force) noexcept = 0;
  /// Returns the force that the device holds after the last write(). A driver implements this
  /// function if it may send another force than requested, for example because the device answers
  /// late or the driver has its own limit. The returned force is logged. Returns nullopt if the
  /// device holds the requested force. Haptic thread only, after write().
  [[nodiscard]] virtual std::optional<Force> held_force() const noexcept { return std::nullopt; }
  /// Returns true if the pen is at the end of an arm. The position of an arm cannot jump, so the
  /// loop keeps jumps out of the ink (LeapFilter). A mouse or a joystick may jump.
  [[nodiscard]] virtual bool is_arm() const noexcept { return false; }
  /// Sets the force to zero immediately. Must work in any state.
  virtual void stop() noexcept = 0;
};

/// The pose that a hand aims at.
struct Aim {
  Vec3 target_mm;
  std::optional<double> pressure{};
  std::uint32_t buttons = 0;
  std::optional<double> tilt_deg{};  ///< tilt of the pen from the normal, 0..90; absent if unknown

  friend constexpr bool operator==(const Aim&, const Aim&) noexcept = default;
};

/// Input of a simulated hand. A mouse, a tablet or a script sets the position that the hand wants
/// for the pen; forces displace the pen from it.
class HandInput {
 public:
  virtual ~HandInput() = default;

  /// Sets the pose to aim at, which is used from the next read() on. Pressure, buttons and tilt are
  /// copied to the samples. Without pressure, contact and push follow from the depth below the
  /// plane.
  virtual void aim(const Aim& aim) noexcept = 0;
  /// Sets the pose for a pen with unknown tilt.
  void aim(const Vec3& target_mm, std::optional<double> pressure, std::uint32_t buttons) noexcept {
    aim(Aim{target_mm, pressure, buttons});
  }
  /// Sets the pose as aim() does, with the time at which the hand had it, on the loop's clock. If
  /// several poses arrive late together, they are played back with their original intervals. An
  /// implementation that cannot play poses back uses the pose immediately.
  virtual void aim_at(std::int64_t time_ns, const Aim& aim) noexcept {
    static_cast<void>(time_ns);
    this->aim(aim);
  }
};

/// A device for which the vendor's library runs the servo loop: its scheduler calls us once per
/// tick on its own thread (OpenHaptics). A `RealtimeThread` that is given a LoopHost runs the loop
/// on the host's thread instead of its own.
class LoopHost {
 public:
  using Tick = void (*)(void* context) noexcept;

  LoopHost() = default;
  LoopHost(const LoopHost&) = delete;
  LoopHost& operator=(const LoopHost&) = delete;
  virtual ~LoopHost() = default;

  /// Starts the loop: until stop_loop() has returned, the host calls `tick(context)` about once per
  /// period of the device's capabilities, always from one thread at a time. Edit thread only.
  ///
  /// Fails if the vendor refuses; the message contains the vendor's text. After a failure `tick` is
  /// not called.
  virtual Result<void> start_loop(Tick tick, void* context) = 0;
  /// Stops the loop. Returns when no call is in progress and no more calls will follow. Has no
  /// effect if no loop runs. Edit thread only.
  virtual void stop_loop() noexcept = 0;
};

}  // namespace felt
