#include "felt/devices/recorded/recorded_device.h"

#include <algorithm>
#include <cmath>

#include "felt/geometry/tilt.h"

namespace felt {

RecordedDevice::RecordedDevice(std::vector<PenSample> recording, const Capabilities& capabilities)
    : recording_(std::move(recording)), capabilities_(capabilities) {
  std::erase_if(recording_, [](const PenSample& s) {
    return !is_finite(s.position) || (s.pressure && !std::isfinite(*s.pressure));
  });
  for (PenSample& s : recording_) s.tilt_deg = checked_tilt(s.tilt_deg);
  for (std::size_t i = 1; i < recording_.size(); ++i) {
    recording_[i].time_ns = std::max(recording_[i].time_ns, recording_[i - 1].time_ns);
  }
}

PenSample RecordedDevice::at(std::int64_t now_ns) const noexcept {
  if (next_ == 0) {
    PenSample before = recording_.front();
    before.position.z = std::max(before.position.z, 0.0);
    before.pressure.reset();
    before.buttons = 0;
    return before;
  }
  PenSample sample = recording_[next_ - 1];
  if (next_ == recording_.size()) return sample;
  const PenSample& to = recording_[next_];
  const double part = static_cast<double>(now_ns - sample.time_ns) /
                      static_cast<double>(to.time_ns - sample.time_ns);
  sample.position = lerp(sample.position, to.position, part);
  if (sample.pressure.value_or(0.0) > 0.0 && to.pressure.value_or(0.0) > 0.0) {
    sample.pressure = *sample.pressure + part * (*to.pressure - *sample.pressure);
  }
  if (sample.tilt_deg && to.tilt_deg) {
    sample.tilt_deg = std::lerp(*sample.tilt_deg, *to.tilt_deg, part);
  }
  return sample;
}

tl::expected<PenSample, DeviceFault> RecordedDevice::read(std::int64_t now_ns) noexcept {
  if (recording_.empty()) return tl::unexpected(DeviceFault::kBadData);
  const PenSample* missed = nullptr;
  while (next_ < recording_.size() && recording_[next_].time_ns <= now_ns) {
    if (in_contact(recording_[next_]) != showed_contact_) missed = &recording_[next_];
    ++next_;
  }
  PenSample sample = at(now_ns);
  if (missed != nullptr && in_contact(sample) == showed_contact_) sample = *missed;
  showed_contact_ = in_contact(sample);
  const double dt_s = started_ ? 1e-9 * static_cast<double>(now_ns - last_ns_) : 0.0;
  started_ = true;
  last_ns_ = now_ns;
  sample.velocity = velocity_.update(sample.position, dt_s);
  sample.time_ns = now_ns;
  return sample;
}

tl::expected<void, DeviceFault> RecordedDevice::write(const Force& force) noexcept {
  if (!is_finite(force)) {
    last_force_ = {};
    return tl::unexpected(DeviceFault::kBadData);
  }
  last_force_ = force;
  return {};
}

}  // namespace felt
