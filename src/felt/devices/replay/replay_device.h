#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "felt/haptics/pen_sample.h"
#include "felt/rt/device.h"

namespace felt {

/// A device that plays recorded samples (R55), such as the `pen` events of a script.
///
/// At a time between two samples the position is interpolated linearly; pressure too, if both
/// touch, and tilt, if both have it; otherwise these and the buttons are those of the earlier
/// sample. Before the first sample the pen is at its position, but in the air; after the last it
/// stays. The velocity is low-passed from the positions as in a driver. A touch that begins and
/// ends between two reads shows in the second of them, and so does a short lift, so that a slow
/// loop neither loses a dot nor joins two strokes.
///
/// Times never go back: a sample that would is moved to its predecessor's time; samples that are
/// not finite are left out. Forces have no effect; the last one is stored.
/// read() on the haptic thread: real-time safe, O(samples passed).
class ReplayDevice final : public Device {
 public:
  /// `capabilities` are those that it reports, for the forces of a session.
  ReplayDevice(std::vector<PenSample> recording, const Capabilities& capabilities);

  [[nodiscard]] std::string_view name() const noexcept override { return "replay"; }
  [[nodiscard]] const Capabilities& capabilities() const noexcept override { return capabilities_; }
  /// Fails with kBadData if the recording is empty.
  tl::expected<PenSample, DeviceFault> read(std::int64_t now_ns) noexcept override;
  /// Fails with kBadData if the force is not finite.
  tl::expected<void, DeviceFault> write(const Force& force) noexcept override;
  void stop() noexcept override { last_force_ = {}; }

  /// Returns the last force asked for.
  [[nodiscard]] const Force& last_force() const noexcept { return last_force_; }
  /// Returns true after the last sample has been reached.
  [[nodiscard]] bool is_over() const noexcept { return next_ >= recording_.size(); }

 private:
  [[nodiscard]] PenSample at(std::int64_t now_ns) const noexcept;

  std::vector<PenSample> recording_;
  Capabilities capabilities_;
  VelocityFilter velocity_;
  Force last_force_;
  std::size_t next_ = 0;  // first sample in the future
  bool started_ = false;
  bool showed_contact_ = false;
  std::int64_t last_ns_ = 0;
};

}  // namespace felt
