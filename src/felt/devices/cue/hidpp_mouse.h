#pragma once

#include <array>
#include <cstdint>
#include <memory>

#include "felt/devices/cue/cue_pacer.h"
#include "felt/devices/cue/hid_descriptor.h"
#include "felt/driver/cue_device.h"
#include "felt/driver/driver.h"
#include "felt/driver/hidraw_port.h"

namespace felt {

/// Logitech's HID++ 2.0 as far as a haptic mouse needs it: long reports of 20 bytes, number 0x11,
/// {device, feature, function and software, 16 bytes}. What Solaar or another program says to the
/// same device is told apart by the software number, and left alone; nothing is ever stored in the
/// device, whose strength stays what its owner has set.
///
/// Feature 0x19B0, haptics, as others have found it out (Solaar, OpenLogi): function 0 tells which
/// waveforms there are, function 4 plays one.
class HidppMouse final : public CueDevice {
 public:
  static constexpr std::uint16_t kHaptics = 0x19B0;
  static constexpr std::size_t kBytes = 20;
  static constexpr std::uint8_t kLongReport = 0x11;
  static constexpr std::uint8_t kDirect = 0xFF;   ///< device number without a receiver
  static constexpr std::uint8_t kMostPaired = 6;  ///< of a receiver: 1..6
  static constexpr std::uint8_t kSoftware = 0x5;  ///< ours; Solaar takes 0xB..0xF

  /// Looks for a mouse with haptics, at the receiver's numbers or directly; some 0.25 s for each
  /// number that does not answer. Error: none there, or errno's text.
  static Result<std::unique_ptr<CueDevice>> open(std::unique_ptr<HidrawPort> port, bool is_receiver,
                                                 DeviceDescriptor descriptor);

  [[nodiscard]] const DeviceDescriptor& descriptor() const noexcept override { return descriptor_; }
  /// A hand knows when it presses a mouse's button; and a mouse only ticks.
  [[nodiscard]] bool plays(CueWaveform waveform) const noexcept override {
    return number_of(waveform) >= 0;
  }
  tl::expected<void, DeviceFault> play(const Cue& cue, std::int64_t now_ns) noexcept override;
  /// A waveform is over by itself.
  void stop() noexcept override {}

 private:
  using Report = std::array<std::uint8_t, kBytes>;

  HidppMouse(std::unique_ptr<HidrawPort> port, std::uint8_t device, DeviceDescriptor descriptor)
      : port_(std::move(port)), device_(device), descriptor_(std::move(descriptor)) {}

  /// The 16 bytes of the answer. Error: errno; ETIMEDOUT, or EPROTO where the device refuses.
  tl::expected<Report, int> ask(std::uint8_t feature, std::uint8_t function,
                                std::uint16_t argument) noexcept;
  [[nodiscard]] Report request(std::uint8_t feature, std::uint8_t function) const noexcept;
  tl::expected<void, int> find_haptics() noexcept;
  [[nodiscard]] int number_of(CueWaveform waveform) const noexcept;

  std::unique_ptr<HidrawPort> port_;
  std::uint8_t device_;
  DeviceDescriptor descriptor_;
  std::uint8_t feature_ = 0;     // its number at this device
  std::uint32_t waveforms_ = 0;  // a bit each
  CuePacer pacer_{4.0, 10.0};
  bool is_gone_ = false;
};

}  // namespace felt
