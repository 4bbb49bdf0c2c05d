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

/// A haptic mouse that uses Logitech's HID++ 2.0. Only the long reports of the protocol are needed.
/// They have 20 bytes: report number 0x11, device, feature, function and software number (4 bits
/// each), and 16 bytes of data. Answers to Solaar or another program that uses the same device have
/// another software number and are ignored. No setting of the device is changed, so the strength of
/// its vibration stays as the user has set it.
///
/// Feature 0x19B0, haptics, as found by other projects (Solaar, OpenLogi): function 0 lists the
/// available waveforms, function 4 plays one.
class HidppMouse final : public CueDevice {
 public:
  static constexpr std::uint16_t kHaptics = 0x19B0;
  static constexpr std::size_t kBytes = 20;
  static constexpr std::uint8_t kLongReport = 0x11;
  static constexpr std::uint8_t kDirect = 0xFF;   ///< device number without a receiver
  static constexpr std::uint8_t kMaxPaired = 6;   ///< on a receiver, the numbers are 1..6
  static constexpr std::uint8_t kSoftware = 0x5;  ///< our software number; Solaar uses 0xB..0xF

  /// Looks for a mouse with haptics: at each device number of a receiver, or at kDirect. Takes
  /// about 0.25 s for each number that does not answer. Fails if a transfer fails (with the text of
  /// errno), or if no mouse with haptics answers.
  static Result<std::unique_ptr<CueDevice>> open(std::unique_ptr<HidrawPort> port, bool is_receiver,
                                                 DeviceDescriptor descriptor);

  [[nodiscard]] const DeviceDescriptor& descriptor() const noexcept override { return descriptor_; }
  /// Returns false for presses, because the hand already feels the click of the mouse button, and
  /// for continuous waveforms, because such a mouse can only play short ticks.
  [[nodiscard]] bool plays(CueWaveform waveform) const noexcept override {
    return number_of(waveform) >= 0;
  }
  tl::expected<void, DeviceFault> play(const Cue& cue, std::int64_t now_ns) noexcept override;
  /// Does nothing, because a waveform ends by itself.
  void stop() noexcept override {}

 private:
  using Report = std::array<std::uint8_t, kBytes>;

  HidppMouse(std::unique_ptr<HidrawPort> port, std::uint8_t device, DeviceDescriptor descriptor)
      : port_(std::move(port)), device_(device), descriptor_(std::move(descriptor)) {}

  /// Sends a request and returns the report that answers it. Fails with errno, for example with
  /// ETIMEDOUT, or with EPROTO if the device refuses.
  tl::expected<Report, int> ask(std::uint8_t feature, std::uint8_t function,
                                std::uint16_t argument) noexcept;
  [[nodiscard]] Report request(std::uint8_t feature, std::uint8_t function) const noexcept;
  tl::expected<void, int> find_haptics() noexcept;
  [[nodiscard]] int number_of(CueWaveform waveform) const noexcept;

  std::unique_ptr<HidrawPort> port_;
  std::uint8_t device_;
  DeviceDescriptor descriptor_;
  std::uint8_t feature_ = 0;     // number of the haptics feature on this device
  std::uint32_t waveforms_ = 0;  // one bit for each available waveform
  CuePacer pacer_{4.0, 10.0};
  bool is_gone_ = false;
};

}  // namespace felt
