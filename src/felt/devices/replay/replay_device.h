#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "felt/haptics/pen_sample.h"
#include "felt/rt/device.h"

namespace felt {

/// A device that plays recorded samples (R55): what `pen` events of a script come through.
///
/// At a time between two samples the position lies on the line between them; pressure too, where
/// both of them touch, and lean, where both have it; else these and buttons are the earlier one's.
/// Before the first sample the pen is where that one is, but in the air; after the last it stays.
/// The velocity is low-passed from the positions as a driver does it. A touch that begins and ends
/// between two reads shows in the second of them, and so does a short lift: a slow loop loses no
/// dot and joins no two strokes.
///
/// Times never run backwards in a recording: a sample that does is moved to its predecessor's time;
/// samples that are not finite are left out. Forces have no effect, the last one is remembered.
///
/// read() on the haptic thread: real-time safe, O(samples passed).
class ReplayDevice final : public Device {
 public:
  /// `capabilities` is what it says of itself, for the forces that a session makes meanwhile.
  ReplayDevice(std::vector<PenSample> recording, const Capabilities& capabilities);

  [[nodiscard]] std::string_view name() const noexcept override { return "replay"; }
  [[nodiscard]] const Capabilities& capabilities() const noexcept override { return capabilities_; }
  /// kBadData where the recording is empty.
  tl::expected<PenSample, DeviceFault> read(std::int64_t now_ns) noexcept override;
  /// A force that is not finite is refused with kBadData.
  tl::expected<void, DeviceFault> write(const Force& force) noexcept override;
  void stop() noexcept override { last_force_ = {}; }

  /// What was asked for last.
  [[nodiscard]] const Force& last_force() const noexcept { return last_force_; }
  /// True once the last sample has been reached.
  [[nodiscard]] bool is_over() const noexcept { return next_ >= recording_.size(); }

 private:
  [[nodiscard]] PenSample at(std::int64_t now_ns) const noexcept;

  std::vector<PenSample> recording_;
  Capabilities capabilities_;
  VelocityFilter velocity_;
  Force last_force_;
  std::size_t next_ = 0;  // the first sample that lies in the future
  bool started_ = false;
  bool showed_contact_ = false;
  std::int64_t last_ns_ = 0;
};

}  // namespace felt
