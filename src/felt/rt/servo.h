#pragma once

#include <atomic>
#include <cstdint>

#include "felt/haptics/force_model.h"
#include "felt/haptics/safety_chain.h"
#include "felt/rt/device.h"
#include "felt/rt/latest_value.h"
#include "felt/rt/loop_stats.h"
#include "felt/rt/spsc_ring.h"

namespace felt {

/// Everything about one tick of the haptic loop: what `--forces` writes and the force panel plots.
struct TickReport {
  PenSample sample;  ///< as read; the last good one where reading failed
  bool sample_ok = false;
  double dt_s = 0.0;
  Force asked;       ///< sum of the model's terms after the cross-fade
  Force sent;        ///< after the safety chain
  ForceTerms terms;  ///< of the current model, before the cross-fade
  SafetyReport safety;
};

struct ServoOptions {
  /// Loop period, 0.2..4 ms (R50).
  std::int64_t period_ns = 1'000'000;
  /// Cross-fade between models of different fade_id (architecture section 10).
  double cross_fade_s = 0.020;
  SafetyLimits limits;
};

/// The body of the haptic loop (architecture section 4): read, evaluate, limit, write, hand over.
///
/// step(now) is called by a real-time thread (`RealtimeThread`), by a vendor's servo callback, or
/// with a virtual clock by replay and tests; it neither knows nor cares. step() is real-time safe:
/// no allocation, lock, I/O or exception.
class Servo {
 public:
  static constexpr std::size_t kRingSamples = 16384;  ///< 16 s at 1 kHz
  using Ring = SpscRing<PenSample, kRingSamples>;

  /// The device must outlive the servo. Forces are off until arm().
  Servo(Device& device, const ServoOptions& options);

  /// One tick. Haptic thread.
  const TickReport& step(std::int64_t now_ns) noexcept;

  // Edit thread.
  /// From the next tick on. Wait-free.
  void publish(const ForceModel& model) noexcept;
  /// "I am alive": call at least every 100 ms with the loop's clock.
  void heartbeat(std::int64_t now_ns) noexcept;
  /// The user allows forces. Any thread.
  void arm() noexcept;
  /// The user's force-off key. Any thread; takes effect on the next tick.
  void disarm() noexcept;
  /// Samples in order, all of them, for the session and for the saver.
  [[nodiscard]] Ring& for_edit() noexcept { return edit_ring_; }
  [[nodiscard]] Ring& for_saver() noexcept { return saver_ring_; }
  /// The newest tick, for display. Edit thread.
  [[nodiscard]] const TickReport& latest() noexcept;

  /// Haptic thread, or when no thread runs.
  [[nodiscard]] const LoopStats& stats() const noexcept { return stats_; }

 private:
  Ring edit_ring_;
  Ring saver_ring_;
  LoopStats stats_;
};

}  // namespace felt
