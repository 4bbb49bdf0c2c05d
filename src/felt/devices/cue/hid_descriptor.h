#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "felt/base/result.h"

namespace felt {

/// Returns a HID usage: the page in the upper 16 bits, the number in the lower 16 bits.
constexpr std::uint32_t hid_usage(std::uint16_t page, std::uint16_t id) noexcept {
  return std::uint32_t{page} << 16 | id;
}

enum class HidReportKind : std::uint8_t { kInput, kOutput, kFeature };

/// A numeric field in a report.
struct HidField {
  HidReportKind kind = HidReportKind::kInput;
  std::uint8_t report = 0;  ///< number of the report; 0 if not numbered
  std::uint32_t usage = 0;
  std::uint32_t collection = 0;   ///< usage of the innermost collection that has a usage
  std::uint32_t application = 0;  ///< usage of the outermost collection
  std::uint32_t group = 0;        ///< number of the outermost collection, counted from 1
  bool is_constant = false;
  bool is_array = false;  ///< an array of usages, not one value
  std::size_t bit = 0;    ///< position of the first bit, counted after the report number
  std::size_t bits = 0;   ///< 1..32
  std::int32_t minimum = 0, maximum = 0;                    ///< logical range; minimum <= maximum
  std::int32_t physical_minimum = 0, physical_maximum = 0;  ///< if both are 0, the logical range
  int exponent = 0;                                         ///< power of ten of the physical unit
  std::uint32_t unit = 0;                                   ///< coded as in the descriptor
};

/// The reports of a HID device.
struct HidDescriptor {
  std::vector<HidField> fields;

  /// Returns the size of a report in bytes, with its number and padding, or 0 if the device does
  /// not have this report.
  [[nodiscard]] std::size_t report_bytes(HidReportKind kind, std::uint8_t report) const noexcept;
  [[nodiscard]] bool numbers_reports() const noexcept { return is_numbered; }

  bool is_numbered = false;
  /// Sizes of the reports in bits, by HidReportKind and report number. They include fields without
  /// a usage, such as padding.
  std::array<std::array<std::uint32_t, 256>, 3> report_bits{};
};

/// Parses a report descriptor (USB Device Class Definition for HID 1.11, section 6.2.2). The
/// device is not trusted: depth, fields and bits are bounded, and an invalid item is an error.
/// Fails with the reason and the byte position.
Result<HidDescriptor> read_hid_descriptor(std::span<const std::uint8_t> bytes);
inline constexpr std::size_t kMaxHidBytes = 4096;  ///< size limit of a descriptor, as in the kernel
inline constexpr std::size_t kMaxHidFields = 1024;  ///< maximum number of fields that are stored
inline constexpr std::size_t kMaxReportBits = 65536;

/// Returns the value of a field in a report that begins with its number, or 0 if the report is too
/// short. The value is signed if the field's minimum is negative.
std::int64_t hid_value(std::span<const std::uint8_t> report, const HidField& field) noexcept;
/// Sets the value of a field in a report. Clamps the value to the range of the field. Does not
/// write bits beyond the end of a short report.
void set_hid_value(std::span<std::uint8_t> report, const HidField& field,
                   std::int64_t value) noexcept;

}  // namespace felt
