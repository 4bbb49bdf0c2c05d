#pragma once

#include <cstdint>

#include "felt/base/result.h"
#include "felt/haptics/cue.h"
#include "felt/rt/device.h"

namespace felt {

struct DeviceDescriptor;

/// A device that plays waveforms and knows no newtons: a haptic pen, a mouse, a touchpad, a game
/// controller (architecture section 5: every tool feeds both classes). Edit thread; closed, and
/// silent, by its destructor. Fed by a CueLaw as a rule, 50 times a second at most; drivers leave
/// out what the device could not follow.
class CueDevice {
 public:
  CueDevice() = default;
  CueDevice(const CueDevice&) = delete;
  CueDevice& operator=(const CueDevice&) = delete;
  virtual ~CueDevice() = default;

  [[nodiscard]] virtual const DeviceDescriptor& descriptor() const noexcept = 0;
  /// Can it play this, itself or by its nearest relative?
  [[nodiscard]] virtual bool plays(CueWaveform waveform) const noexcept = 0;
  /// `now_ns` is any clock that only grows. Error: kDisconnected, then for ever; kOther where it
  /// refuses this cue, and may take another.
  virtual tl::expected<void, DeviceFault> play(const Cue& cue, std::int64_t now_ns) noexcept = 0;
  /// Silence, at once. Must work in any state.
  virtual void stop() noexcept = 0;
};

}  // namespace felt
