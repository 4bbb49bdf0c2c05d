#pragma once

#include <array>
#include <atomic>
#include <cstdint>

#include "felt/devices/evdev/effect_plan.h"
#include "felt/driver/evdev_port.h"
#include "felt/rt/latest_value.h"

namespace felt {

/// Keeps the newest planned effects playing on a stick. Two threads use it:
///
///   haptic thread   want(plan), silence(): wait-free, no kernel call
///   worker          serve(now): uploads changes, plays, and plays again before effects end
///
/// Only the worker writes to the device, because a write to an event node waits for a lock in the
/// kernel, and an upload holds this lock for as long as its transfer takes. So silence() only sets
/// a request. The worker checks it before each play, after each upload, and whenever it serves, so
/// effects stop at the latest after kLookNs (the time between two calls of serve()) plus the time
/// of the transfer in progress. If the worker is blocked, in the kernel or elsewhere, effects end
/// by themselves, kEffectMs after the device accepted the last upload or play. This limit does not
/// depend on any other part of the program.
class EffectKeeper {
 public:
  static constexpr std::int64_t kPlayAgainNs = 40'000'000;  ///< well before kEffectMs
  static constexpr std::int64_t kUploadNs = 8'000'000;      ///< minimum time between two uploads

  /// `port` must outlive this. Requires that no plan pushes with more than `max_n`. Then all
  /// effects on the device together never push with more than `max_n` either, not even when only
  /// some effects of a new plan have been uploaded.
  EffectKeeper(EvdevPort& port, const StickForces& stick, double max_n) noexcept
      : port_(port), stick_(stick), max_n_(max_n) {}

  // These are called on the haptic thread.
  void want(const EffectPlan& plan) noexcept;
  /// Requests zero force. The worker stops the effects when it next checks. Does nothing if want()
  /// was not called since the last silence().
  void silence() noexcept;
  /// Returns the errno of the newest request that the device refused since the last success, or 0.
  /// Safe to call from any thread.
  [[nodiscard]] int error() const noexcept { return error_.load(std::memory_order_relaxed); }

  // These are called on the worker, or on the thread that does its work (in tests).

  /// Stops effects immediately if silence was requested. Uploads and plays effects if kUploadNs
  /// have passed since it last did so.
  void serve(std::int64_t now_ns) noexcept;
  /// Stops and erases all effects. Requires that no thread calls serve() at the same time.
  void erase_all() noexcept;

 private:
  [[nodiscard]] bool is_silenced() const noexcept;
  bool play(std::size_t kind, int times) noexcept;
  void stop(std::size_t kind) noexcept;
  void stop_all() noexcept;
  void renew(std::int64_t now_ns) noexcept;
  void probe() noexcept;
  bool update(std::size_t kind, const EffectPlan& plan, bool must_play) noexcept;

  EvdevPort& port_;
  StickForces stick_;
  double max_n_;
  LatestValue<EffectPlan> plans_;
  // Incremented by each want() after a silence(), and by each silence() after a want(). So `epoch_`
  // is odd while a plan is wanted.
  std::atomic<std::uint32_t> epoch_{0};
  std::atomic<int> error_{0};
  // Used by the worker only.
  std::array<std::int16_t, EffectPlan::kKinds> ids_{-1, -1, -1};
  std::uint32_t served_epoch_ = 0;
  EffectPlan there_;  // the last uploaded effects, and which of these play
  std::int64_t played_ns_ = 0, renewed_ns_ = 0;
  bool has_renewed_ = false;
};

}  // namespace felt
