#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "felt/base/result.h"

namespace felt {

/// A usage of HID: page in the upper, number in the lower 16 bits.
constexpr std::uint32_t hid_usage(std::uint16_t page, std::uint16_t id) noexcept {
  return std::uint32_t{page} << 16 | id;
}

enum class HidReportKind : std::uint8_t { kInput, kOutput, kFeature };

/// A number in a report.
struct HidField {
  HidReportKind kind = HidReportKind::kInput;
  std::uint8_t report = 0;  ///< its number; 0: the device numbers none
  std::uint32_t usage = 0;
  std::uint32_t collection = 0;   ///< usage of the innermost named collection around it
  std::uint32_t application = 0;  ///< of the outermost one
  std::uint32_t group = 0;        ///< number of the outermost one, counted from 1
  bool is_constant = false;
  bool is_array = false;                                    ///< of usages, not a value of one
  std::size_t bit = 0;                                      ///< of the report behind its number
  std::size_t bits = 0;                                     ///< 1..32
  std::int32_t minimum = 0, maximum = 0;                    ///< logical; minimum <= maximum
  std::int32_t physical_minimum = 0, physical_maximum = 0;  ///< both 0: as the logical ones
  int exponent = 0;                                         ///< of ten, of the physical unit
  std::uint32_t unit = 0;                                   ///< as the descriptor codes it
};

/// What a HID device says of its reports.
struct HidDescriptor {
  std::vector<HidField> fields;

  /// Bytes of a report with its number and what only fills it up, or 0 where there is none.
  [[nodiscard]] std::size_t report_bytes(HidReportKind kind, std::uint8_t report) const noexcept;
  [[nodiscard]] bool numbers_reports() const noexcept { return is_numbered; }

  bool is_numbered = false;
  /// By HidReportKind and number: all bits, those of no usage too.
  std::array<std::array<std::uint32_t, 256>, 3> report_bits{};
};

/// Reads a report descriptor (USB Device Class Definition for HID 1.11, section 6.2.2). What comes
/// from a device is not to be trusted: bounded in depth, fields and bits, and an item that makes no
/// sense is an error. Error: what is wrong, and at which byte.
Result<HidDescriptor> read_hid_descriptor(std::span<const std::uint8_t> bytes);
inline constexpr std::size_t kMostHidBytes = 4096;   ///< of a descriptor, as the kernel has it
inline constexpr std::size_t kMostHidFields = 1024;  ///< that are kept
inline constexpr std::size_t kMostReportBits = 65536;

/// The value of a field in a report that begins with its number; nothing where it does not reach so
/// far. With sign where its minimum is negative.
std::int64_t hid_value(std::span<const std::uint8_t> report, const HidField& field) noexcept;
/// Sets it, clamped to what the field can hold. Nothing where the report does not reach so far.
void set_hid_value(std::span<std::uint8_t> report, const HidField& field,
                   std::int64_t value) noexcept;

}  // namespace felt
