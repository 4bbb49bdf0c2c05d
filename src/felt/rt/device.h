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

/// Why a device could not be read or written. An enumeration, because the haptic thread must not
/// make strings; `describe` gives the sentence, drivers keep the vendor's own words for the edit
/// side.
enum class DeviceFault : std::uint8_t {
  kDisconnected,
  kNotCalibrated,
  kForcesOff,  ///< by a button, a velocity guard, a watchdog of its own
  kOverheated,
  kBadData,  ///< what it said makes no sense
  kOther,
};

/// One sentence for a person.
std::string_view describe(DeviceFault fault) noexcept;

/// A force-feedback stylus, or something that stands for one (R55): the simulated stylus, a
/// recording, a driver.
///
/// read(), write() and stop() are called on the haptic thread only, once each per tick in this
/// order, and must not block beyond the device's own transfer, allocate or throw. The frame is that
/// of the sheet; a driver maps into it.
class Device {
 public:
  Device() = default;
  Device(const Device&) = delete;
  Device& operator=(const Device&) = delete;
  virtual ~Device() = default;

  /// Short name for people and for `--device`.
  [[nodiscard]] virtual std::string_view name() const noexcept = 0;
  /// Fixed while the device is open. Any thread.
  [[nodiscard]] virtual const Capabilities& capabilities() const noexcept = 0;
  /// The pen now. If nothing newer has come since the last read(), the same sample again with the
  /// same time_ns: whoever measures speeds must not take it for a pen that stands still. `now_ns`
  /// is the loop's clock; a simulated device advances to it.
  virtual tl::expected<PenSample, DeviceFault> read(std::int64_t now_ns) noexcept = 0;
  /// What the pen was between the last read and the one before it, oldest first, one a call; none
  /// when all of them were told. For pens that are faster than the loop and push back with nothing:
  /// no force depends on these. On the haptic thread, after read().
  virtual std::optional<PenSample> between() noexcept { return std::nullopt; }
  /// Along the pen, of any length, in the frame of its places, as of the last read(): for drivers
  /// that know how it is held but not yet where the sheet lies. OpenDevice, which does, makes
  /// PenSample::lean_deg of it. None where the device does not know. On the haptic thread, after
  /// read().
  virtual std::optional<Vec3> pen_axis() noexcept { return std::nullopt; }
  /// Asks for a force, which holds until the next one.
  virtual tl::expected<void, DeviceFault> write(const Force& force) noexcept = 0;
  /// The force that the device holds after the last write(), if a driver can send something else
  /// than what was asked: the other side is late, or a bound of its own cuts. This is what is
  /// logged. Nullopt: what was asked. On the haptic thread, after write().
  [[nodiscard]] virtual std::optional<Force> held_force() const noexcept { return std::nullopt; }
  /// Returns true if the pen is at the end of an arm, whose position cannot leap: the loop keeps
  /// leaps out of the ink (LeapFilter). A mouse or a joystick may leap.
  [[nodiscard]] virtual bool is_arm() const noexcept { return false; }
  /// No force, at once. Must work in any state.
  virtual void stop() noexcept = 0;
};

/// What a hand wants from now on.
struct Aim {
  Vec3 target_mm;
  std::optional<double> pressure{};
  std::uint32_t buttons = 0;
  std::optional<double> lean_deg{};  ///< of the pen from the upright, 0..90; absent where unknown

  friend constexpr bool operator==(const Aim&, const Aim&) noexcept = default;
};

/// What drives a simulated hand: a mouse, a tablet or a script says where the hand wants the pen;
/// forces then move the pen away from there.
class HandInput {
 public:
  virtual ~HandInput() = default;

  /// From the next read() on. Pressure, buttons and lean are passed through to the samples; without
  /// pressure the depth in the plane decides.
  virtual void aim(const Aim& aim) noexcept = 0;
  /// Likewise, of a pen whose lean nobody knows.
  void aim(const Vec3& target_mm, std::optional<double> pressure, std::uint32_t buttons) noexcept {
    aim(Aim{target_mm, pressure, buttons});
  }
  /// The same for a hand that says when it was there, on the loop's clock: what arrives late and
  /// several at once is played in its own spacing. A hand that cannot takes it as it comes.
  virtual void aim_at(std::int64_t time_ns, const Aim& aim) noexcept {
    static_cast<void>(time_ns);
    this->aim(aim);
  }
};

/// A device whose maker runs the servo loop: the vendor's scheduler calls us, once a tick, on a
/// thread of its own (OpenHaptics). `RealtimeThread` uses it in the place of a thread of its own
/// when it is given one.
class LoopHost {
 public:
  using Tick = void (*)(void* context) noexcept;

  LoopHost() = default;
  LoopHost(const LoopHost&) = delete;
  LoopHost& operator=(const LoopHost&) = delete;
  virtual ~LoopHost() = default;

  /// From now on the host calls `tick(context)` about once a period of the device's capabilities,
  /// always from one thread at a time, until stop_loop() has returned. Edit thread.
  ///
  /// Error: the vendor refuses; the message has its words. Nothing is called then.
  virtual Result<void> start_loop(Tick tick, void* context) = 0;
  /// Returns when no call is under way and none will come. Edit thread; nothing when none runs.
  virtual void stop_loop() noexcept = 0;
};

}  // namespace felt
