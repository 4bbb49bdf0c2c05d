#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <tl/expected.hpp>

#include "felt/base/result.h"
#include "felt/driver/evdev_codes.h"

namespace felt {

/// One event of an input device.
struct EvdevEvent {
  std::uint16_t type = 0, code = 0;
  std::int32_t value = 0;
};

/// The state of an axis, in the device's counts.
struct EvdevAxis {
  std::int32_t value = 0, minimum = 0, maximum = 0;
  std::int32_t flat = 0;  ///< size of the dead zone around the middle
};

/// A spring, damper or friction along one axis, in the kernel's units. The centre is -32767 at the
/// minimum of the axis and 32767 at its maximum. Saturations (0..65535) and coefficients
/// (-32767..32767) are relative to the device's full force. With a positive coefficient, a spring
/// pulls to the centre, and a damper or friction brakes.
struct EvdevCondition {
  std::uint16_t right_saturation = 0, left_saturation = 0;
  std::int16_t right_coefficient = 0, left_coefficient = 0;
  std::uint16_t deadband = 0;
  std::int16_t center = 0;
  friend constexpr bool operator==(const EvdevCondition&, const EvdevCondition&) = default;
};

/// An effect that the device plays by itself. `type` is one of the kFf... constants in
/// evdev_codes.h. Fields that do not apply to that type are ignored.
struct EvdevEffect {
  std::uint16_t type = 0;
  std::int16_t id =
      -1;  ///< -1 for a new effect; otherwise the effect to replace, which keeps playing
  /// Direction of a constant force: 0 towards the user, 0x4000 left, 0x8000 away, 0xC000 right.
  std::uint16_t direction = 0;
  std::uint16_t length_ms = 0;                 ///< 0 plays until stopped
  std::array<EvdevCondition, 2> conditions{};  ///< conditions of axes x and y
  std::int16_t level = 0;                      ///< level of a constant force
  std::uint16_t strong = 0, weak = 0;          ///< strengths of the two motors of a rumble effect
  std::uint16_t hid_usage = 0;                 ///< waveform of a haptic effect (HID page 0x0E)
  std::uint16_t intensity_percent = 0;         ///< intensity of a haptic effect, 0..100
  friend constexpr bool operator==(const EvdevEffect&, const EvdevEffect&) = default;
};

/// An open input device of the kernel (/dev/input/eventN); tests use a fake. Errors are errno
/// numbers. ENODEV is permanent: the device is gone.
///
/// next() never waits and may be called on the haptic thread. All other functions wait for the
/// kernel's lock on the device; an upload holds this lock until its transfer is over. Two threads
/// may call different functions at the same time. Closing the port stops and erases all effects.
class EvdevPort {
 public:
  EvdevPort() = default;
  EvdevPort(const EvdevPort&) = delete;
  EvdevPort& operator=(const EvdevPort&) = delete;
  virtual ~EvdevPort() = default;

  /// Reads the next event; returns false if no event is waiting.
  virtual tl::expected<bool, int> next(EvdevEvent& event) noexcept = 0;
  virtual tl::expected<EvdevAxis, int> axis(std::uint16_t code) noexcept = 0;
  /// Returns true if the key or button is down.
  virtual tl::expected<bool, int> key(std::uint16_t code) noexcept = 0;
  /// Returns how many effects the device can hold.
  virtual tl::expected<int, int> slots() noexcept = 0;
  /// Uploads an effect and returns its id. Fails with ENOSPC if all slots are used, and with EINVAL
  /// if the device does not support effects of this type.
  virtual tl::expected<std::int16_t, int> upload(const EvdevEffect& effect) noexcept = 0;
  virtual tl::expected<void, int> erase(std::int16_t id) noexcept = 0;
  /// Writes an event to the device: {kFf, id, number of plays (0 stops)} or {kFf, kFfGain,
  /// 0..65535}.
  virtual tl::expected<void, int> send(const EvdevEvent& event) noexcept = 0;
};

/// Opens a device node. Fails with kNotFound if the node does not exist, and with kIo for any other
/// error. The message contains the path and the text of errno.
Result<std::unique_ptr<EvdevPort>> open_evdev(const std::string& path);

/// Returns an effect as the bytes of the kernel's struct ff_effect. For a haptic effect
/// (FF_HAPTIC), hid_usage and intensity_percent are stored at the offsets that the kernel uses
/// (since Linux 6.18), even if the installed headers are older and do not declare them.
inline constexpr std::size_t kEvdevEffectBytes = 48;
std::array<std::byte, kEvdevEffectBytes> packed(const EvdevEffect& effect) noexcept;

}  // namespace felt
