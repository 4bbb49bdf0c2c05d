#pragma once

#include <bitset>
#include <memory>

#include "felt/devices/cue/cue_pacer.h"
#include "felt/driver/cue_device.h"
#include "felt/driver/driver.h"
#include "felt/driver/evdev_port.h"

namespace felt {

/// A touchpad with FF_HAPTIC (Linux 6.18 and newer), or a game controller that rumbles. Uses at
/// most two effects: a continuous effect, which ends by itself after kCueHoldNs, and a short
/// effect.
class EvdevCues final : public CueDevice {
 public:
  /// Uses FF_HAPTIC if `is_haptic`, otherwise FF_RUMBLE.
  EvdevCues(std::unique_ptr<EvdevPort> port, bool is_haptic, DeviceDescriptor descriptor)
      : port_(std::move(port)), is_haptic_(is_haptic), descriptor_(std::move(descriptor)) {}
  ~EvdevCues() override;

  [[nodiscard]] const DeviceDescriptor& descriptor() const noexcept override { return descriptor_; }
  /// Returns true if the device plays this waveform. A touchpad counts as able to play a waveform
  /// until it has refused that waveform once.
  [[nodiscard]] bool plays(CueWaveform waveform) const noexcept override;
  tl::expected<void, DeviceFault> play(const Cue& cue, std::int64_t now_ns) noexcept override;
  void stop() noexcept override;

 private:
  enum Slot : std::uint8_t { kHum, kTick, kSlots };

  [[nodiscard]] EvdevEffect rumble_of(const Cue& cue) const noexcept;
  tl::expected<void, int> play_haptic(const Cue& cue, Slot slot) noexcept;
  tl::expected<void, int> start(EvdevEffect effect, Slot slot) noexcept;
  void end(Slot slot) noexcept;

  std::unique_ptr<EvdevPort> port_;
  bool is_haptic_;
  DeviceDescriptor descriptor_;
  std::array<std::int16_t, kSlots> ids_{-1, -1};
  std::bitset<kSlots> playing_;
  std::bitset<16> refused_;  // waveforms that the device refused
  CuePacer pacer_{5.0, 25.0};
  bool is_gone_ = false;
};

}  // namespace felt
