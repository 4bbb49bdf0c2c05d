#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <tl/expected.hpp>

#include "felt/base/result.h"

namespace felt {

/// An open HID device without a driver in between (/dev/hidrawN), or in tests a fake. Reports begin
/// with their number, 0 where the device numbers none. Errors are numbers of errno: ENODEV and EIO
/// of an unplugged device are for ever. Any one thread.
class HidrawPort {
 public:
  HidrawPort() = default;
  HidrawPort(const HidrawPort&) = delete;
  HidrawPort& operator=(const HidrawPort&) = delete;
  virtual ~HidrawPort() = default;

  /// Sends an output report, whole or not at all; as long as the device's transfer takes.
  virtual tl::expected<void, int> write(std::span<const std::uint8_t> report) noexcept = 0;
  /// The next input report, of which `room` keeps what fits; 0: none came within the time (0 = does
  /// not wait). Others who have the device open get all of them, too.
  virtual tl::expected<std::size_t, int> read(std::span<std::uint8_t> room,
                                              std::int64_t within_ns) noexcept = 0;
  /// Asks for a feature report: its number in room[0], then what came stands behind it. Returns the
  /// length with the number.
  virtual tl::expected<std::size_t, int> feature(std::span<std::uint8_t> room) noexcept = 0;
};

/// Opens a node of the kernel. Error: kNotFound, or kIo with the path and errno's own text.
Result<std::unique_ptr<HidrawPort>> open_hidraw(const std::string& path);

}  // namespace felt
