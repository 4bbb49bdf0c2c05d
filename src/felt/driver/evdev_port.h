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

/// One thing that an input device said.
struct EvdevEvent {
  std::uint16_t type = 0, code = 0;
  std::int32_t value = 0;
};

/// What the kernel knows of an axis, in the device's counts.
struct EvdevAxis {
  std::int32_t value = 0, minimum = 0, maximum = 0;
  std::int32_t flat = 0;  ///< around the middle nothing counts
};

/// A spring, a damper or a friction along one axis, in the kernel's units: positions -32767..32767
/// over the way of the axis, saturations 0..65535 and coefficients -32767..32767 of the device's
/// full force. Positive coefficients pull to the centre, or brake.
struct EvdevCondition {
  std::uint16_t right_saturation = 0, left_saturation = 0;
  std::int16_t right_coefficient = 0, left_coefficient = 0;
  std::uint16_t deadband = 0;
  std::int16_t center = 0;
  friend constexpr bool operator==(const EvdevCondition&, const EvdevCondition&) = default;
};

/// An effect that a device plays by itself; of the fields those that its type (a kFf... number of
/// evdev_codes.h) has.
struct EvdevEffect {
  std::uint16_t type = 0;
  std::int16_t id = -1;  ///< -1: a new one; else that one is replaced, and goes on if it plays
  /// Of a constant: whereto it pushes, 0 towards the person, 0x4000 left, 0x8000 away, 0xC000
  /// right.
  std::uint16_t direction = 0;
  std::uint16_t length_ms = 0;                 ///< 0: until it is stopped
  std::array<EvdevCondition, 2> conditions{};  ///< of x and y
  std::int16_t level = 0;                      ///< of a constant
  std::uint16_t strong = 0, weak = 0;          ///< of a rumble: both motors
  std::uint16_t hid_usage = 0;                 ///< of a haptic: the waveform of page 0x0E
  std::uint16_t intensity_percent = 0;         ///< likewise, 0..100
  friend constexpr bool operator==(const EvdevEffect&, const EvdevEffect&) = default;
};

/// An open input device of the kernel (/dev/input/eventN), or in tests a fake. Errors are numbers
/// of errno: ENODEV is gone for ever.
///
/// next() waits for nothing, and may be called on the haptic thread. Everything else waits for the
/// kernel's lock of the device, which an upload holds until its transfer is over. Two threads may
/// call different functions at the same time. Closing ends and erases all effects.
class EvdevPort {
 public:
  EvdevPort() = default;
  EvdevPort(const EvdevPort&) = delete;
  EvdevPort& operator=(const EvdevPort&) = delete;
  virtual ~EvdevPort() = default;

  /// The next event; false: none waits.
  virtual tl::expected<bool, int> next(EvdevEvent& event) noexcept = 0;
  virtual tl::expected<EvdevAxis, int> axis(std::uint16_t code) noexcept = 0;
  /// Is the key or button down?
  virtual tl::expected<bool, int> key(std::uint16_t code) noexcept = 0;
  /// How many effects the device keeps at a time.
  virtual tl::expected<int, int> slots() noexcept = 0;
  /// Returns the effect's id. ENOSPC: no slot is free; EINVAL: not one of its types.
  virtual tl::expected<std::int16_t, int> upload(const EvdevEffect& effect) noexcept = 0;
  virtual tl::expected<void, int> erase(std::int16_t id) noexcept = 0;
  /// Tells the device something: {kFf, id, times to play (0 = stop)}, {kFf, kFfGain, 0..65535}.
  virtual tl::expected<void, int> send(const EvdevEvent& event) noexcept = 0;
};

/// Opens a node of the kernel. Error: kNotFound, or kIo with the path and errno's own text.
Result<std::unique_ptr<EvdevPort>> open_evdev(const std::string& path);

/// As the kernel takes it: the bytes of a struct ff_effect, with FF_HAPTIC at its place whatever
/// the headers know.
inline constexpr std::size_t kEvdevEffectBytes = 48;
std::array<std::byte, kEvdevEffectBytes> packed(const EvdevEffect& effect) noexcept;

}  // namespace felt
