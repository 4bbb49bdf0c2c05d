#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

#include "felt/rt/device.h"

namespace felt {

/// A short text that is copied as bytes, so that the haptic thread can hand a vendor's own words
/// over. What does not fit is cut at the end, never inside a UTF-8 character.
class ShortText {
 public:
  static constexpr std::size_t kBytes = 191;

  constexpr ShortText() noexcept = default;
  explicit constexpr ShortText(std::string_view text) noexcept {
    std::size_t size = std::min(text.size(), kBytes);
    while (size > 0 && size < text.size() &&
           (static_cast<unsigned char>(text[size]) & 0xC0) == 0x80)
      --size;
    std::copy_n(text.begin(), size, bytes_.begin());
    size_ = static_cast<std::uint8_t>(size);
  }
  [[nodiscard]] constexpr std::string_view view() const noexcept { return {bytes_.data(), size_}; }
  [[nodiscard]] constexpr bool empty() const noexcept { return size_ == 0; }
  friend constexpr bool operator==(const ShortText& a, const ShortText& b) noexcept {
    return a.view() == b.view();
  }

 private:
  std::array<char, kBytes> bytes_{};
  std::uint8_t size_ = 0;
};

/// How an open device is. Trivially copyable: made on the haptic thread, read on the edit side
/// through a LatestValue.
struct DeviceStatus {
  std::optional<DeviceFault> fault;         ///< that holds at present; none: it reads and writes
  std::optional<DeviceFault> last_fault;    ///< the newest one, though it be over
  ShortText vendor_words;                   ///< the maker's own text for the newest fault, verbatim
  std::int64_t vendor_code = 0;             ///< and its number
  ShortText notice;                         ///< its newest word that is no fault: a flat battery,
                                            ///< a filter of its own that acts on our forces
  std::uint64_t faults = 0;                 ///< since it was opened
  std::uint64_t reads = 0;                  ///< that succeeded, since it was opened
  std::optional<double> motor_temperature;  ///< 0 cold .. 1 too warm, the warmest motor
  double rate_hz = 0.0;  ///< that the device itself says it is served at; 0 = says nothing
};

}  // namespace felt
