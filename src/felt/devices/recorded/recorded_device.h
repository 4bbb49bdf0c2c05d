#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "felt/haptics/pen_sample.h"
#include "felt/rt/device.h"

namespace felt {

/// A device that plays recorded samples (R55), such as the `pen` events of a script.
///
/// Between two samples, the position is interpolated linearly. Pressure is interpolated if both
/// samples touch, and tilt if both samples have a tilt; otherwise the values of the earlier sample
/// are used. The buttons are always those of the earlier sample. Before the time of the first
/// sample, the pen is at the first position, but in the air; after the last sample, the pen stays
/// at the last position. The velocity is computed from the positions with a low-pass filter, as in
/// a driver. If a touch begins and ends between two reads, the second read still reports the touch.
/// If a lift begins and ends between two reads, the second read reports the lift. So a slow loop
/// neither loses a dot nor joins two strokes.
///
/// A sample whose time is earlier than that of the previous sample gets the time of the previous
/// sample. Samples that are not finite are left out. Forces have no effect; the last force is
/// stored.
///
/// read() is used on the haptic thread. It is real-time safe, and its duration is linear in the
/// number of samples since the last read.
class RecordedDevice final : public Device {
 public:
  /// The device reports `capabilities`; a session computes its forces for these capabilities.
  RecordedDevice(std::vector<PenSample> recording, const Capabilities& capabilities);

  [[nodiscard]] std::string_view name() const noexcept override { return "replay"; }
  [[nodiscard]] const Capabilities& capabilities() const noexcept override { return capabilities_; }
  /// Fails with kBadData if the recording is empty.
  tl::expected<PenSample, DeviceFault> read(std::int64_t now_ns) noexcept override;
  /// Fails with kBadData if the force is not finite.
  tl::expected<void, DeviceFault> write(const Force& force) noexcept override;
  void stop() noexcept override { last_force_ = {}; }

  /// Returns the force of the last write().
  [[nodiscard]] const Force& last_force() const noexcept { return last_force_; }
  /// Returns true after the last sample has been reached.
  [[nodiscard]] bool is_over() const noexcept { return next_ >= recording_.size(); }

 private:
  [[nodiscard]] PenSample at(std::int64_t now_ns) const noexcept;

  std::vector<PenSample> recording_;
  Capabilities capabilities_;
  VelocityFilter velocity_;
  Force last_force_;
  std::size_t next_ = 0;  // index of the first sample that was not reached yet
  bool started_ = false;
  bool showed_contact_ = false;
  std::int64_t last_ns_ = 0;
};

}  // namespace felt
