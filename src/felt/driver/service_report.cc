#include "felt/driver/service_report.h"

namespace felt {

void ServiceReport::restart_pace() noexcept {
  pace_ = ServicePace(period_ns_);
  pace_words_.reset();
  is_pace_reported_ = false;
}

void ServiceReport::follow(std::int64_t ns, bool has_state) noexcept {
  pace_.tick(ns, has_state);
  if (!pace_.is_off()) {
    pace_words_.reset();
    is_pace_reported_ = false;
  } else if (!pace_words_) {
    pace_words_ = pace_.waited_ns() > ServicePace::kHoldNs ? words_.late : words_.slow;
  }
}

Force ServiceReport::allowed(const Force& force,
                             const std::optional<ShortText>& no_force) const noexcept {
  return is_finite(force) && !no_force ? pace_.share() * force : Force{};
}

tl::expected<void, DeviceFault> ServiceReport::written(
    const Force& force, const std::optional<ShortText>& no_force) noexcept {
  if (!is_finite(force)) {
    return failed(DeviceFault::kBadData, ShortText("The requested force is not a number."));
  }
  if (!no_force) return {};
  force_stopped_.reset();
  return failed(DeviceFault::kForcesOff, *no_force);
}

// While forces are off because the service is late, a missing state is not a new fault. After
// another fault such as a brake, the service may still be late: then shows that fault again, but
// does not count it again.
tl::unexpected<DeviceFault> ServiceReport::failed(DeviceFault fault, const ShortText& words,
                                                  int code) noexcept {
  const bool is_known =
      pace_words_ && status_.fault == DeviceFault::kForcesOff && fault == DeviceFault::kOther;
  const bool is_same = status_.fault == fault && status_.vendor_words == words;
  if (is_known || is_same) return tl::unexpected(fault);
  status_.fault = status_.last_fault = fault;
  status_.vendor_words = words;
  status_.vendor_code = code;
  const bool is_pace = pace_words_ && fault == DeviceFault::kForcesOff && words == *pace_words_;
  if (!(is_pace && is_pace_reported_)) ++status_.faults;
  is_pace_reported_ = is_pace_reported_ || is_pace;
  publish();
  return tl::unexpected(fault);
}

DeviceStatus ServiceReport::shown() noexcept {
  shown_.update();
  return shown_.get();
}

}  // namespace felt
