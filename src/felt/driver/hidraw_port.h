#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <tl/expected.hpp>

#include "felt/base/result.h"

namespace felt {

/// An open HID device that is accessed directly, bypassing its kernel driver (/dev/hidrawN). Tests
/// use a fake. Reports begin with their number, which is 0 if the device does not number them.
/// Errors are errno numbers. ENODEV is permanent, and so is EIO once the device has been unplugged.
/// For use by one thread at a time.
class HidrawPort {
 public:
  HidrawPort() = default;
  HidrawPort(const HidrawPort&) = delete;
  HidrawPort& operator=(const HidrawPort&) = delete;
  virtual ~HidrawPort() = default;

  /// Sends an output report, either completely or not at all. Blocks as long as the transfer to the
  /// device takes.
  virtual tl::expected<void, int> write(std::span<const std::uint8_t> report) noexcept = 0;
  /// Reads the next input report, cut to the size of `room`, and returns its size. Returns 0 if no
  /// report came within the given time; if the time is 0, does not wait. Reading does not take
  /// reports away from other programs that have opened the device.
  virtual tl::expected<std::size_t, int> read(std::span<std::uint8_t> room,
                                              std::int64_t within_ns) noexcept = 0;
  /// Requests the feature report whose number is in room[0], and stores its data from room[1] on.
  /// Returns the length including the number.
  virtual tl::expected<std::size_t, int> feature(std::span<std::uint8_t> room) noexcept = 0;
};

/// Opens a device node. Fails with kNotFound if the node does not exist, and with kIo for any other
/// error. The message contains the path and the text of errno.
Result<std::unique_ptr<HidrawPort>> open_hidraw(const std::string& path);

}  // namespace felt
