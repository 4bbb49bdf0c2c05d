#pragma once

#include <memory>

#include "felt/devices/cue/cue_pacer.h"
#include "felt/devices/cue/haptic_reports.h"
#include "felt/driver/cue_device.h"
#include "felt/driver/driver.h"

namespace felt {

/// A haptic pen, touchpad or mouse with a Simple Haptic Controller, used through its HID reports.
class HidHaptics final : public CueDevice {
 public:
  /// Requires that HapticReports::ask has succeeded.
  HidHaptics(std::unique_ptr<HidrawPort> port, HapticReports reports, DeviceDescriptor descriptor)
      : port_(std::move(port)), reports_(std::move(reports)), descriptor_(std::move(descriptor)) {}
  ~HidHaptics() override { stop(); }

  [[nodiscard]] const DeviceDescriptor& descriptor() const noexcept override { return descriptor_; }
  [[nodiscard]] bool plays(CueWaveform waveform) const noexcept override {
    return reports_.ordinal(waveform) != 0;
  }
  tl::expected<void, DeviceFault> play(const Cue& cue, std::int64_t now_ns) noexcept override;
  void stop() noexcept override;

 private:
  tl::expected<void, DeviceFault> send(const Cue& cue) noexcept;

  std::unique_ptr<HidrawPort> port_;
  HapticReports reports_;
  DeviceDescriptor descriptor_;
  CuePacer pacer_;
  bool hums_ = false;  // a continuous cue may be playing
  bool is_gone_ = false;
};

}  // namespace felt
