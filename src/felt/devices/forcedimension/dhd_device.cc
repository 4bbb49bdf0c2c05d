#include "felt/devices/forcedimension/dhd_device.h"

#include <cmath>
#include <cstring>
#include <utility>

#include "felt/base/constants.h"

namespace felt::dhd {
namespace {

constexpr double kFarthestMm = 2000.0;  // longer than any such arm
constexpr double kLongestGapS = 0.1;

bool is_sane(const Vec3& v) noexcept {
  return std::abs(v.x) <= kFarthestMm && std::abs(v.y) <= kFarthestMm &&
         std::abs(v.z) <= kFarthestMm;
}

}  // namespace

DhdDevice::~DhdDevice() {
  // This is done in every state, so that no force stays in effect and the arm is braked.
  static_cast<void>(send({}));
  api_.stop(id_);
  library_->close(id_);
}

tl::expected<PenSample, DeviceFault> DhdDevice::read(std::int64_t now_ns) noexcept {
  const bool was_gap = now_ns - now_ns_ >= kGapNs || now_ns < now_ns_;
  now_ns_ = now_ns;
  if (!is_gone_ && (ticks_++ % kStatusEvery == 0 || was_gap)) look_at_status();
  if (is_gone_) return tl::unexpected(DeviceFault::kDisconnected);
  if (!is_home_) {
    if (read_fault_ != DeviceFault::kNotCalibrated) {
      note(DeviceFault::kNotCalibrated, 0, "it does not know its position");
    }
    return read_failed(DeviceFault::kNotCalibrated);
  }
  auto sample = ask_sample();
  if (!sample) return read_failed(sample.error());
  read_fault_.reset();
  ++status_.reads;
  speed_mm_per_s_ = norm(sample->velocity);
  publish();
  return sample;
}

tl::expected<PenSample, DeviceFault> DhdDevice::ask_sample() noexcept {
  Vec3 p;
  const int done = api_.get_position(&p.x, &p.y, &p.z, id_);
  if (done < 0) return tl::unexpected(vendor_fault());
  PenSample sample;
  sample.time_ns = now_ns_;
  sample.position = kMmPerM * p;
  if (!is_sane(sample.position)) {
    return tl::unexpected(note(DeviceFault::kBadData, 0, "it reported an impossible position"));
  }
  // If the call came too soon (kTimeGuard), the library repeats the last position. This is not an
  // error, and it does not mean that the arm stood still, so the velocity is kept.
  if (done != kTimeGuard) {
    const double dt_s = placed_ns_ ? 1e-9 * static_cast<double>(now_ns_ - *placed_ns_) : 0.0;
    if (dt_s < 0.0 || dt_s > kLongestGapS) velocity_.reset();
    velocity_.update(sample.position, dt_s);
    placed_ns_ = now_ns_;
  }
  sample.velocity = velocity_.velocity();
  sample.buttons = ask_buttons();
  return sample;
}

std::uint32_t DhdDevice::ask_buttons() const noexcept {
  std::uint32_t buttons = 0;
  if (api_.get_button_mask != nullptr) {
    buttons = api_.get_button_mask(id_);
  } else if (api_.get_button != nullptr && api_.get_button(0, id_) > 0) {
    buttons = 1;
  }
  if (type_.second_button_is_first && (buttons & 2U) != 0) buttons |= 1U;
  return buttons;
}

void DhdDevice::look_at_status() noexcept {
  std::array<int, kStatusRoom> status{};
  if (api_.get_status(status.data(), id_) < 0) {
    if (const DeviceFault fault = vendor_fault(); fault == DeviceFault::kDisconnected) {
      read_failed(fault);
    }
  } else if (status[kStatusConnected] == 0) {
    read_failed(note(DeviceFault::kDisconnected, kErrorNoDevice, "it is no longer connected"));
  } else {
    look_whether_home(status[kStatusReset] != 0);
    if (is_home_)
      look_at_motors(status);
    else if (motors_ != Motors::kBraked)
      brake();
  }
}

// Asks DRD whether the device is homed. Each such call needs a transfer over USB, so the function
// asks only when the flag in the status has changed, in either direction.
void DhdDevice::look_whether_home(bool reset_flag) noexcept {
  if (!api_.has_drd()) {
    is_home_ = !reset_flag;
  } else if (!is_home_ || reset_flag != reset_flag_at_home_) {
    is_home_ = api_.drd_is_initialized(id_);
    reset_flag_at_home_ = reset_flag;
  }
}

DeviceFault DhdDevice::vendor_fault() noexcept {
  const int code = api_.error_get_last();
  const char* words = api_.error_get_last_str();
  DeviceFault fault = DeviceFault::kOther;
  if (code == kErrorCom || code == kErrorNoDevice || code == kErrorNoDriver) {
    fault = DeviceFault::kDisconnected;
  } else if (code == kErrorGeometry || code == kErrorRedundancy) {
    fault = DeviceFault::kBadData;
  }
  return note(fault, code,
              words != nullptr ? std::string_view(words, strnlen(words, ShortText::kBytes + 1))
                               : std::string_view());
}

DeviceFault DhdDevice::note(DeviceFault fault, std::int64_t code, std::string_view words) noexcept {
  status_.last_fault = fault;
  status_.vendor_code = code;
  status_.vendor_words = ShortText(words);
  ++status_.faults;
  return fault;
}

tl::unexpected<DeviceFault> DhdDevice::read_failed(DeviceFault fault) noexcept {
  read_fault_ = fault;
  failed_ns_ = now_ns_;
  is_gone_ = is_gone_ || fault == DeviceFault::kDisconnected;
  publish();
  return tl::unexpected(fault);
}

// A failed write does not make read() fail; the next read() finds out whether the device is
// disconnected.
tl::unexpected<DeviceFault> DhdDevice::write_failed(DeviceFault fault) noexcept {
  write_fault_ = fault;
  failed_ns_ = now_ns_;
  publish();
  return tl::unexpected(fault);
}

void DhdDevice::publish() noexcept {
  status_.fault = read_fault_ ? read_fault_ : write_fault_;
  published_.publish(status_);
}

}  // namespace felt::dhd
