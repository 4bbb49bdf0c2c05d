// The functions that run in a tick, on the scheduler's thread.
#include "felt/devices/openhaptics/openhaptics_device.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "felt/devices/openhaptics/hd_faults.h"

namespace felt {
namespace {

constexpr std::size_t kMaxErrorsRead = 16;  // errors read in one call; the others wait
constexpr std::uint64_t kStatusEvery = 16;  // ticks
constexpr double kFarthestMm = 1e5;         // larger positions are invalid
constexpr double kFastestMmPerS = 1e6;
constexpr unsigned kButtonBits = 0xF;
constexpr double kMinAxis = 0.5;    // the axis is invalid if its length is far from 1
constexpr std::size_t kMotors = 6;  // maximum; the library fills the values of existing motors

bool is_believable(const PenSample& pen) noexcept {
  const auto within = [](const Vec3& v, double largest) {
    return std::abs(v.x) <= largest && std::abs(v.y) <= largest &&
           std::abs(v.z) <= largest;  // false for NaN
  };
  return within(pen.position, kFarthestMm) && within(pen.velocity, kFastestMmPerS);
}

}  // namespace

void OpenHapticsDevice::begin_tick() noexcept {
  tick_is_open_ = true;
  frame_ = Frame::kNotYet;
  ++ticks_;
}

void OpenHapticsDevice::end_tick() noexcept {
  if (frame_ == Frame::kOpen) {
    close_frame({});
    force_fault_ = graver(force_fault_, drain());
    if (force_fault_ == DeviceFault::kDisconnected) die();
  }
  tick_is_open_ = false;
  if (ticks_ % kStatusEvery == 0) publish();
}

tl::expected<PenSample, DeviceFault> OpenHapticsDevice::read(std::int64_t now_ns) noexcept {
  if (is_gone_) return tl::unexpected(DeviceFault::kDisconnected);
  if (!tick_is_open_) {
    return refuse(DeviceFault::kOther, "read outside of the device software's loop");
  }
  if (frame_ == Frame::kDone)
    return last_;  // a tick has only one frame; repeats the sample of that frame
  now_ns_ = now_ns;
  if (frame_ == Frame::kNotYet) open_frame();
  last_ = sense(now_ns);
  if (last_) ++status_.reads;
  return last_;
}

tl::expected<PenSample, DeviceFault> OpenHapticsDevice::sense(std::int64_t now_ns) noexcept {
  std::array<double, 3> place{}, way{};
  int buttons = 0;
  call_.get_doubles(hd::parameter::kPosition, place.data());
  call_.get_doubles(hd::parameter::kVelocity, way.data());
  call_.get_integers(hd::parameter::kButtons, &buttons);
  sense_attitude();
  sense_state();
  const std::optional<DeviceFault> fault = drain();
  if (fault == DeviceFault::kDisconnected) {
    die();
    return tl::unexpected(*fault);
  }
  if (fault == DeviceFault::kOther) return tl::unexpected(*fault);
  force_fault_ = graver(force_fault_, fault);
  if (!is_home_) return refuse(DeviceFault::kNotCalibrated, "calibration needs manual input");
  const PenSample pen{now_ns,
                      {place[0], place[1], place[2]},
                      {way[0], way[1], way[2]},
                      {},
                      static_cast<unsigned>(buttons) & kButtonBits};
  if (!is_believable(pen)) return refuse(DeviceFault::kBadData, "an impossible position");
  return pen;
}

// The stylus lies along its own z axis, the third column of its transform.
void OpenHapticsDevice::sense_attitude() noexcept {
  axis_.reset();
  if (!senses_.attitude) return;
  std::array<double, 16> transform{};
  call_.get_doubles(hd::parameter::kTransform, transform.data());
  const Vec3 axis{transform[8], transform[9], transform[10]};
  const double size = norm(axis);
  if (size > kMinAxis && size < 1.0 / kMinAxis) axis_ = axis;  // false for NaN
}

void OpenHapticsDevice::sense_state() noexcept {
  unsigned char state = hd::kFalse;
  if (senses_.safety_switch) {
    call_.get_booleans(hd::parameter::kSafetySwitch, &state);
    // A device without a switch always reports it as open. Therefore the switch is only used after
    // it was closed once.
    is_held_ = state != hd::kFalse || !has_safety_switch_;
    has_safety_switch_ = has_safety_switch_ || state != hd::kFalse;
  }
  if (senses_.inkwell) {
    state = hd::kFalse;
    call_.get_booleans(hd::parameter::kInkwell, &state);
    is_in_inkwell_ = state != hd::kFalse;
  }
  is_home_ = call_.check_calibration() != hd::calibration::kNeedsPerson;
  if (senses_.temperature) {
    std::array<double, kMotors> warm{};
    call_.get_doubles(hd::parameter::kMotorTemperature, warm.data());
    double warmest = 0.0;
    for (const double motor : warm) warmest = motor <= warmest ? warmest : motor;  // keeps NaN
    if (std::isfinite(warmest)) status_.motor_temperature = warmest;
    warmth_.allow(warmest);
  }
  if (senses_.rate && ticks_ % kStatusEvery == 0) {
    int hz = 0;
    call_.get_integers(hd::parameter::kMeasuredUpdateRate, &hz);
    status_.rate_hz = std::max(hz, 0);
  }
}

Force OpenHapticsDevice::bounded(const Force& asked, bool& was_finite) noexcept {
  const ForceGate::Passed passed = gate_.pass(asked, now_ns_);
  was_finite = passed.was_finite;
  const double size = norm(passed.force);
  if (size > warmth_.allowed_n()) gate_.sent_less((warmth_.allowed_n() / size) * passed.force);
  return gate_.held();
}

tl::expected<void, DeviceFault> OpenHapticsDevice::write(const Force& asked) noexcept {
  if (is_gone_) return tl::unexpected(DeviceFault::kDisconnected);
  bool was_finite = true;
  Force force = bounded(asked, was_finite);
  std::optional<DeviceFault> fault = std::exchange(force_fault_, std::nullopt);
  if (!is_held_ || is_in_inkwell_) {
    force = {};
    gate_.release();
    fault = graver(fault, DeviceFault::kForcesOff);
    note(DeviceFault::kForcesOff,
         is_in_inkwell_ ? "the stylus is in its inkwell" : "the safety switch is open", 0);
  }
  if (tick_is_open_ && frame_ != Frame::kDone) {
    if (frame_ == Frame::kNotYet) open_frame();
    close_frame(force);
    fault = graver(fault, drain());
  } else {
    // The frame is over, so the force cannot be sent any more; switches the output off instead.
    release();
    if (force != Force{}) {
      fault = graver(fault, DeviceFault::kOther);
      note(DeviceFault::kOther, "a force outside of a frame", 0);
    }
  }
  if (fault == DeviceFault::kDisconnected) die();
  if (!was_finite && !is_gone_) {
    return refuse(DeviceFault::kBadData, "the force requested is not a number");
  }
  if (fault) return tl::unexpected(*fault);
  if (last_ && status_.fault) {
    status_.fault.reset();
    publish();
  }
  return {};
}

void OpenHapticsDevice::stop() noexcept {
  if (tick_is_open_ && frame_ != Frame::kDone && !is_gone_) {
    if (frame_ == Frame::kNotYet) open_frame();
    close_frame({});
  }
  release();
  const std::optional<DeviceFault> fault = drain();
  if (fault == DeviceFault::kDisconnected) die();
}

void OpenHapticsDevice::open_frame() noexcept {
  call_.begin_frame(handle_);
  frame_ = Frame::kOpen;
}

void OpenHapticsDevice::close_frame(const Force& force) noexcept {
  if (!is_output_on_ && force != Force{}) {
    call_.enable(hd::capability::kForceOutput);
    is_output_on_ = true;
  }
  const std::array<double, 3> newtons{force.x, force.y, force.z};
  call_.set_doubles(hd::parameter::kForce, newtons.data());
  call_.end_frame(handle_);
  frame_ = Frame::kDone;
}

// Switches the force output off immediately, inside or outside of a tick. Sending zero is not
// enough, because the tick's frame may be over.
void OpenHapticsDevice::release() noexcept {
  call_.disable(hd::capability::kForceOutput);
  is_output_on_ = false;
  gate_.release();
}

// Makes all later calls fail with kDisconnected. Ends the current frame, so that the library does
// not wait for its end.
void OpenHapticsDevice::die() noexcept {
  is_gone_ = true;
  if (frame_ == Frame::kOpen) close_frame({});
  release();
  drain_errors(call_, kMaxErrorsRead, [](const hd::ErrorInfo&) {});
  status_.fault = DeviceFault::kDisconnected;
  publish();
}

std::optional<DeviceFault> OpenHapticsDevice::drain() noexcept {
  std::optional<DeviceFault> gravest;
  hd::ErrorInfo reported{};
  drain_errors(call_, kMaxErrorsRead, [&](const hd::ErrorInfo& error) {
    const std::optional<DeviceFault> with = graver(gravest, fault_of(error.code));
    if (with != gravest) reported = error;  // keeps the newest of the most serious errors
    gravest = with;
  });
  if (gravest) {
    const char* words = call_.error_words(reported.code);
    note(*gravest, words != nullptr ? words : "", reported.code);
  }
  return gravest;
}

void OpenHapticsDevice::note(DeviceFault fault, std::string_view words,
                             std::int64_t code) noexcept {
  const bool is_news = status_.fault != fault || status_.vendor_code != code;
  status_.fault = fault;
  status_.last_fault = fault;
  status_.vendor_words = ShortText(words);
  status_.vendor_code = code;
  if (!is_news) return;
  ++status_.faults;
  publish();
}

tl::unexpected<DeviceFault> OpenHapticsDevice::refuse(DeviceFault fault,
                                                      std::string_view words) noexcept {
  note(fault, words, 0);
  return tl::unexpected(fault);
}

}  // namespace felt
