#pragma once

#include <array>
#include <atomic>
#include <cstdint>

#include "felt/devices/evdev/effect_plan.h"
#include "felt/driver/evdev_port.h"
#include "felt/rt/latest_value.h"

namespace felt {

/// Keeps on a stick the effects that were planned last. Two sides:
///
///   haptic thread   want(plan), silence(): wait-free, no call of the kernel
///   worker          serve(now): uploads what is new, plays, and plays again before effects end
///
/// All that is told to the device is told by the worker: whoever writes to an event node waits for
/// the kernel's lock of that device, which an upload holds for as long as its transfer takes. So
/// silence() only says that it is wanted. The worker looks before each play and after each upload,
/// else whenever it serves: effects stop within kLookNs and the transfer under way. Where the
/// worker stands still, in the kernel or altogether, they end by themselves, kEffectMs after the
/// device took the last upload or play: that is the bound that needs nobody.
class EffectKeeper {
 public:
  static constexpr std::int64_t kPlayAgainNs = 40'000'000;  ///< of kEffectMs
  static constexpr std::int64_t kUploadNs = 8'000'000;      ///< the least between two uploads

  /// The port must outlive it. At no moment, between two uploads either, do the effects of a stick
  /// like this push with more than `most_n` together, as long as no plan does.
  EffectKeeper(EvdevPort& port, const StickForces& stick, double most_n) noexcept
      : port_(port), stick_(stick), most_n_(most_n) {}

  // Haptic thread.
  void want(const EffectPlan& plan) noexcept;
  /// No force: from when the worker looks next. Nothing where nothing is wanted.
  void silence() noexcept;
  /// errno of the newest thing that the device refused since the last success; 0: none. Any thread.
  [[nodiscard]] int error() const noexcept { return error_.load(std::memory_order_relaxed); }

  // Worker, or whoever stands in its place.

  /// Silences at once where that is wanted; uploads and plays when kUploadNs have passed.
  void serve(std::int64_t now_ns) noexcept;
  /// Stops and erases all. While nobody serves.
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
  double most_n_;
  LatestValue<EffectPlan> plans_;
  // Counts each want() after a silence(), and each silence() after a want(): odd while wanted.
  std::atomic<std::uint32_t> epoch_{0};
  std::atomic<int> error_{0};
  // Worker's.
  std::array<std::int16_t, EffectPlan::kKinds> ids_{-1, -1, -1};
  std::uint32_t served_epoch_ = 0;
  EffectPlan there_;  // uploaded last, and what of it plays
  std::int64_t played_ns_ = 0, renewed_ns_ = 0;
  bool has_renewed_ = false;
};

}  // namespace felt
