#pragma once

#include <cstdint>

#include "felt/base/result.h"
#include "felt/haptics/cue.h"
#include "felt/rt/device.h"

namespace felt {

struct DeviceDescriptor;

/// A device that plays waveforms instead of forces: a haptic pen, a mouse, a touchpad, a game
/// controller. Every tool provides output for force devices and for cue devices
/// (docs/design/devices.md#kinds-of-devices). Usually a CueLaw calls play(), at most 50 times a
/// second. Drivers skip cues that come too fast for the device. Used on the edit thread. The
/// destructor silences and closes the device.
class CueDevice {
 public:
  CueDevice() = default;
  CueDevice(const CueDevice&) = delete;
  CueDevice& operator=(const CueDevice&) = delete;
  virtual ~CueDevice() = default;

  [[nodiscard]] virtual const DeviceDescriptor& descriptor() const noexcept = 0;
  /// Returns true if the device plays this waveform, directly or as the nearest one it supports.
  [[nodiscard]] virtual bool plays(CueWaveform waveform) const noexcept = 0;
  /// Plays a cue. `now_ns` is the time of any clock that never goes back. Fails with kOther if the
  /// device refuses this cue but may accept other cues. Fails with kDisconnected if the device is
  /// disconnected; all later calls then fail in the same way.
  virtual tl::expected<void, DeviceFault> play(const Cue& cue, std::int64_t now_ns) noexcept = 0;
  /// Silences the device immediately. Implementations must do so in every state of the object, also
  /// after a fault.
  virtual void stop() noexcept = 0;
};

}  // namespace felt
