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

/// Usages of page 0x0E, Haptics (HID Usage Tables 1.4; HUTRR63).
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
inline constexpr std::uint16_t kOrdinals = 0x0A;  ///< page of the lists' entries
inline constexpr std::uint32_t kPen = hid_usage(0x0D, 0x02);
inline constexpr std::uint32_t kDigitizer = hid_usage(0x0D, 0x01);
inline constexpr std::uint32_t kTouchpad = hid_usage(0x0D, 0x05);
inline constexpr std::uint32_t kMouse = hid_usage(0x01, 0x02);
}  // namespace haptic_usage

/// Number of a waveform on page 0x0E: 0x1003 is a click. 0x1002 (stop) for kNone.
std::uint16_t hid_waveform(CueWaveform waveform) noexcept;
/// What may be played where a device has not got a waveform, nearest first; the first is itself.
std::span<const CueWaveform> nearest_waveforms(CueWaveform waveform) noexcept;

/// The haptic controller of a HID device: where its reports have what. Output reports are made for
/// the manual trigger alone; nothing else of the device is ever written.
class HapticReports {
 public:
  /// None where the descriptor has no controller with a manual trigger in an output report.
  static std::optional<HapticReports> find(const HidDescriptor& descriptor);

  /// Asks the device which ordinals are which waveforms, by feature report. Error: errno.
  tl::expected<void, int> ask(HidrawPort& port);

  /// The ordinal of a waveform or, where it has not got it, of its nearest relative; 0: none.
  [[nodiscard]] std::uint32_t ordinal(CueWaveform waveform) const noexcept;
  /// What it says that one play takes, ms; 0: not said.
  [[nodiscard]] std::uint32_t duration_ms(std::uint32_t ordinal) const noexcept;
  /// The output report of a cue, with the number of the report before it; empty: it cannot play it.
  /// A continuous one is cut off after `hold_ms` where the device can do that by itself.
  [[nodiscard]] std::span<const std::uint8_t> play(const Cue& cue, std::uint32_t hold_ms) noexcept;
  [[nodiscard]] bool cuts_off_by_itself() const noexcept { return cutoff_.has_value(); }

  /// What kind of device it belongs to, for people.
  [[nodiscard]] std::string_view kind() const noexcept { return kind_; }
  [[nodiscard]] bool is_touchpad() const noexcept { return is_touchpad_; }

 private:
  static constexpr std::uint32_t kStop = 2;  ///< ordinal by HUTRR63; 1 is none
  static constexpr std::uint32_t kFirstListed = 3;
  static constexpr std::uint32_t kMostOrdinals = 64;

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
