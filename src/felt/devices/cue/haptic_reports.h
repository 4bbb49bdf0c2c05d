#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "felt/devices/cue/hid_descriptor.h"
#include "felt/driver/hidraw_port.h"
#include "felt/haptics/cue.h"

namespace felt {

/// HID usages: those of page 0x0E, Haptics (HID Usage Tables 1.4; HUTRR63), and those that identify
/// kinds of devices.
namespace haptic_usage {
inline constexpr std::uint16_t kPage = 0x0E;
inline constexpr std::uint32_t kController = hid_usage(kPage, 0x01);
inline constexpr std::uint32_t kWaveformList = hid_usage(kPage, 0x10);
inline constexpr std::uint32_t kDurationList = hid_usage(kPage, 0x11);
inline constexpr std::uint32_t kManualTrigger = hid_usage(kPage, 0x21);
inline constexpr std::uint32_t kIntensity = hid_usage(kPage, 0x23);
inline constexpr std::uint32_t kRepeatCount = hid_usage(kPage, 0x24);
inline constexpr std::uint32_t kRetriggerPeriod = hid_usage(kPage, 0x25);
inline constexpr std::uint32_t kCutoffTime = hid_usage(kPage, 0x28);
inline constexpr std::uint16_t kOrdinals = 0x0A;  ///< HID page for the numbers of list entries
inline constexpr std::uint32_t kPen = hid_usage(0x0D, 0x02);
inline constexpr std::uint32_t kDigitizer = hid_usage(0x0D, 0x01);
inline constexpr std::uint32_t kTouchpad = hid_usage(0x0D, 0x05);
inline constexpr std::uint32_t kMouse = hid_usage(0x01, 0x02);
}  // namespace haptic_usage

/// Returns the number of a waveform on page 0x0E, for example 0x1003 for a click. Returns 0x1002
/// (stop) for kNone.
std::uint16_t hid_waveform(CueWaveform waveform) noexcept;
/// Returns the waveform itself, followed by the waveforms that may be played instead of it, most
/// similar first.
std::span<const CueWaveform> nearest_waveforms(CueWaveform waveform) noexcept;

/// The layout of the reports of a HID device's haptic controller. Builds only the output report of
/// the manual trigger, which plays a waveform; never changes a setting of the device.
class HapticReports {
 public:
  /// Returns nullopt if the descriptor has no controller with a manual trigger in an output report.
  static std::optional<HapticReports> find(const HidDescriptor& descriptor);

  /// Asks the device for its waveforms, by feature reports. Each waveform has an ordinal, the
  /// number by which the device plays it. Fails with errno.
  tl::expected<void, int> ask(HidrawPort& port);

  /// Returns the ordinal of a waveform. If the device does not have that waveform, returns the
  /// ordinal of the most similar one in nearest_waveforms(), or 0 if the device has none of them.
  [[nodiscard]] std::uint32_t ordinal(CueWaveform waveform) const noexcept;
  /// Returns the reported duration of one play, ms, or 0 if unknown.
  [[nodiscard]] std::uint32_t duration_ms(std::uint32_t ordinal) const noexcept;
  /// Returns the output report for a cue, starting with the report's number, or an empty span if
  /// the device cannot play the cue. A continuous cue ends after `hold_ms` if the device supports
  /// that.
  [[nodiscard]] std::span<const std::uint8_t> play(const Cue& cue, std::uint32_t hold_ms) noexcept;
  [[nodiscard]] bool cuts_off_by_itself() const noexcept { return cutoff_.has_value(); }

  /// Returns the kind of the device as a text for the user.
  [[nodiscard]] std::string_view kind() const noexcept { return kind_; }
  [[nodiscard]] bool is_touchpad() const noexcept { return is_touchpad_; }

 private:
  static constexpr std::uint32_t kStop = 2;  ///< ordinal of "stop" in HUTRR63 (1 is "none")
  static constexpr std::uint32_t kFirstListed = 3;
  static constexpr std::uint32_t kMaxOrdinals = 64;

  [[nodiscard]] tl::expected<std::vector<std::uint32_t>, int> ask_list(
      HidrawPort& port, std::span<const HidField> list) const;

  std::string_view kind_;
  bool is_touchpad_ = false;
  HidDescriptor descriptor_;
  HidField trigger_;
  std::optional<HidField> intensity_, repeat_, retrigger_, cutoff_;
  std::vector<HidField> waveform_list_, duration_list_;
  std::vector<std::uint32_t> waveforms_, durations_;  // by ordinal
  std::vector<std::uint8_t> report_;
};

}  // namespace felt
