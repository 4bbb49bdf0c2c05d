#pragma once

#include <cstdint>
#include <optional>
#include <tl/expected.hpp>

#include "felt/driver/driver.h"
#include "felt/driver/service_pace.h"
#include "felt/haptics/force.h"
#include "felt/rt/latest_value.h"

namespace felt {

/// What the drivers of devices behind a service or controller share: the pace of the service, the
/// end of write(), and the status, which counts each fault once, however many ticks it lasts.
///
///   read():   report.follow(ns, has_state);
///             if (...) return report.failed(DeviceFault::kOther, words);
///             ++report.status().reads;  report.publish();
///   write():  const auto no_force = ...;  // a reason of the driver, or report.no_force_words()
///             send(report.allowed(force, no_force));
///             return report.written(force, no_force);
///
/// Everything but shown() belongs to the haptic thread, or to the edit thread while no loop runs.
/// Real-time safe.
class ServiceReport {
 public:
  /// The messages for the user while a service is late, or answers regularly but too slowly.
  struct Words {
    ShortText late, slow;
  };
  ServiceReport(std::int64_t period_ns, const Words& words) noexcept
      : period_ns_(period_ns), words_(words), pace_(period_ns) {
    publish();
  }

  /// Begins a new pace, because the service was started or the device was prepared again.
  void restart_pace() noexcept;
  /// Handles a tick of the pace, `ns` after the last one. `has_state` is true if an answer came.
  void follow(std::int64_t ns, bool has_state) noexcept;
  [[nodiscard]] const ServicePace& pace() const noexcept { return pace_; }

  /// Stops the force until write() has reported it once.
  void stop_force(const ShortText& words) noexcept { force_stopped_ = words; }
  void clear_stop() noexcept { force_stopped_.reset(); }
  /// Returns why no force is sent: a stop that is not reported yet, or else the pace. Returns
  /// nullopt if forces may be sent.
  [[nodiscard]] const std::optional<ShortText>& stopped_words() const noexcept {
    return force_stopped_;
  }
  [[nodiscard]] const std::optional<ShortText>& pace_words() const noexcept { return pace_words_; }

  /// Returns the force that write() may send: none if it is not a number or if there is a reason
  /// for no force; less while the service is slow.
  [[nodiscard]] Force allowed(const Force& force,
                              const std::optional<ShortText>& no_force) const noexcept;
  /// Returns the result of write(), and reports the fault.
  tl::expected<void, DeviceFault> written(const Force& force,
                                          const std::optional<ShortText>& no_force) noexcept;
  /// Reports a fault and returns it. `code` is the vendor's number, or 0.
  tl::unexpected<DeviceFault> failed(DeviceFault fault, const ShortText& words,
                                     int code = 0) noexcept;

  /// The status to be published.
  [[nodiscard]] DeviceStatus& status() noexcept { return status_; }
  void publish() noexcept { shown_.publish(status_); }
  /// Returns the status as of the last publish(). For the edit thread.
  [[nodiscard]] DeviceStatus shown() noexcept;

 private:
  std::int64_t period_ns_;
  Words words_;
  ServicePace pace_;
  std::optional<ShortText> force_stopped_;  // until write() has reported it
  std::optional<ShortText> pace_words_;     // message for the user while the pace is off
  bool is_pace_reported_ = false;
  DeviceStatus status_;
  LatestValue<DeviceStatus> shown_;
};

}  // namespace felt
