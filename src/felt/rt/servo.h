#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>

#include "felt/haptics/force_memory.h"
#include "felt/haptics/force_model.h"
#include "felt/haptics/safety/safety_chain.h"
#include "felt/rt/device.h"
#include "felt/rt/latest_value.h"
#include "felt/rt/loop_stats.h"
#include "felt/rt/spsc_ring.h"
#include "felt/rt/thread_roles.h"

namespace felt {

class LeapFilter;

/// The report of one tick of the haptic loop. `--forces` writes it to a file, and the force panel
/// plots it.
struct TickReport {
  PenSample sample;        ///< the sample as read; the last good one if reading failed
  bool sample_ok = false;  ///< the sample was read, and the safety chain accepted it
  double dt_s = 0.0;
  Force asked;            ///< sum of the model's terms after the cross-fade, times the strength
  Force sent;             ///< force that the device holds after the safety chain and the driver
  ForceTerms terms;       ///< of the current model, before cross-fade and strength
  double strength = 1.0;  ///< master strength on this tick, 0..1 (Servo::set_strength)
  SafetyReport safety;
  SolidTouch solid;  ///< of the current model, as of the last accepted sample (SolidSurface)
  std::uint32_t ink_cuts = 0;  ///< strokes ended by jumps of the arm since the start (LeapFilter)
};

struct ServoOptions {
  /// Loop period, 0.2..4 ms (R50). Clamped.
  std::int64_t period_ns = 1'000'000;
  /// Duration of the cross-fade between models of different fade_id
  /// (docs/design/limits.md#cross-fade). Clamped to 0..1 s.
  double cross_fade_s = 0.020;
  /// Usually limits_for(the device). Its period is replaced by `period_ns`.
  SafetyLimits limits;
  /// True: the forces of every tick are queued for a recorder (Servo::for_recorder).
  bool queues_forces = false;
  /// Size of the queues of samples and forces, rounded down to a power of two, 2..16384 (16 s at
  /// 1 kHz). Fewer only for a loop of which nobody reads the queues.
  std::size_t queued = 16384;
};

/// The forces of one tick, for a recorder.
struct TickForces {
  std::int64_t time_ns = 0;  ///< of the sample
  Force asked, sent;         ///< as in TickReport
};

/// The body of the haptic loop (docs/design/loop.md#data-flow): reads a sample from the device,
/// evaluates the force model, limits the force, writes it to the device and queues the sample.
///
/// step(now) is called by a real-time thread (`RealtimeThread`), by a vendor's servo callback, or
/// with a virtual clock by replay and tests (`VirtualClock`). It works the same for all callers.
/// step() is real-time safe: it does not allocate, lock, do I/O or throw. It treats denormal
/// numbers as zero.
///
/// A vendor's callback only needs to call step(now), always on the same thread and with a monotonic
/// clock that was 0 when the session began, and stop() at the end. `RealtimeThread` with a
/// `LoopHost` does that. Clang checks on which thread each function is called (thread_roles.h). The
/// object is large (tens of KiB), so allocate it on the heap.
class Servo {
 public:
  static constexpr std::size_t kRingSamples = ServoOptions{}.queued;  ///< at most
  using Ring = SpscRing<PenSample, kRingSamples>;
  using ForceRing = SpscRing<TickForces, kRingSamples>;
  static constexpr int kMaxBetween = 32;           ///< samples between two ticks (Device::between)
  static constexpr double kStrengthRampS = 0.050;  ///< time for a change from 0 to 1

  /// Makes a servo for a device, which must outlive it. Forces are off until arm().
  Servo(Device& device, const ServoOptions& options);
  ~Servo();

  /// Runs one tick. Haptic thread only.
  const TickReport& step(std::int64_t now_ns) noexcept FELT_NONBLOCKING FELT_NOT_EDIT;
  /// Ends the loop: switches the forces off, also in the device. Call it on the haptic thread, or
  /// on any thread if no loop runs. Afterwards the servo can be armed and stepped again.
  void stop() noexcept FELT_NOT_EDIT;

  // Call the following functions on the edit thread unless they say otherwise.
  /// Sets the force model, which is used from the next tick on. If two models are still being
  /// cross-faded and the new model has another fade_id than the current one, the new model is used
  /// when that cross-fade has ended, at most `cross_fade_s` later. Wait-free. Returns the number of
  /// the model: 1, 2, ...
  std::uint64_t publish(const ForceModel& model) noexcept FELT_NOT_HAPTIC;
  /// Returns the number of the oldest model that a tick may still evaluate. What only models with
  /// smaller numbers point to may be deleted. Safe to call from any thread.
  [[nodiscard]] std::uint64_t oldest_in_use() const noexcept {
    return oldest_in_use_.load(std::memory_order_acquire);
  }
  /// Reports that the edit thread is alive. Call it at least every 100 ms with the loop's clock.
  void heartbeat(std::int64_t now_ns) noexcept FELT_NOT_HAPTIC;
  /// Enables forces on behalf of the user. Safe to call from any thread.
  void arm() noexcept;
  /// Disables forces, for the user's force-off key. Safe to call from any thread. The call takes
  /// effect on the next tick and is never lost: even if arm() is called before that tick, the force
  /// rises again from zero.
  void disarm() noexcept;
  /// Sets the master strength: the fraction of the model's force that is requested from the device,
  /// 0..1 (clamped; NaN is ignored; initially 1). The strength changes linearly, by the whole range
  /// in kStrengthRampS, so that the force stays continuous. Safe to call from any thread.
  void set_strength(double share) noexcept;
  /// Sets the offset in ns: session time minus loop time; initially 0. Force models are evaluated
  /// in session time, which is also the time of the pen samples from which tools make the models.
  /// So a model can compute its age (R30). If the session began before this loop, set the offset
  /// before publish(). Safe to call from any thread.
  void set_session_offset(std::int64_t offset_ns) noexcept;
  [[nodiscard]] std::int64_t session_offset_ns() const noexcept {
    return session_offset_ns_.load(std::memory_order_relaxed);
  }
  /// Return the queues of all accepted samples in order, for the session and for the autosave. If
  /// the device has no forces, all finite samples are accepted, because a mouse may jump. If the
  /// device is an arm, jumps are not accepted; a stroke may end at a jump (LeapFilter).
  [[nodiscard]] Ring& for_edit() noexcept FELT_NOT_HAPTIC { return edit_ring_; }
  [[nodiscard]] Ring& for_autosave() noexcept FELT_NOT_HAPTIC { return autosave_ring_; }
  /// Returns the queue of the forces of all ticks that read an accepted sample, or null without
  /// ServoOptions::queues_forces.
  [[nodiscard]] ForceRing* for_recorder() noexcept FELT_NOT_HAPTIC { return force_ring_.get(); }
  /// Returns the report of the newest tick, for display. It is valid until the next call of
  /// latest(). Edit thread only.
  [[nodiscard]] const TickReport& latest() noexcept FELT_NOT_HAPTIC;

  /// Returns the statistics of the times at which step() was called. Call it on the haptic thread,
  /// or on any thread if no loop runs.
  [[nodiscard]] const LoopStats& stats() const noexcept { return stats_; }
  /// Returns the options after clamping. Safe to call from any thread.
  [[nodiscard]] const ServoOptions& options() const noexcept { return options_; }

 private:
  static constexpr std::int64_t kNever = INT64_MIN;

  void take_orders() noexcept FELT_HAPTIC;
  void take_model() noexcept FELT_HAPTIC;
  void follow_strength() noexcept FELT_HAPTIC;
  Force evaluate(PenSample sample) noexcept FELT_HAPTIC;
  Force force_of(const ForceModel& model, const PenSample& sample, const StiffnessScale& scale,
                 ForceMemory& memory) const noexcept FELT_HAPTIC;
  void sense_and_act(std::int64_t now_ns) noexcept FELT_HAPTIC;
  void hand_over_ink(const PenSample& sample, std::int64_t now_ns) noexcept FELT_HAPTIC;
  void hand_over(const PenSample& sample) noexcept FELT_HAPTIC;
  void hand_over_between() noexcept FELT_HAPTIC;
  void hand_over() noexcept FELT_HAPTIC;

  Device& device_;
  ServoOptions options_;
  bool has_force_;
  bool is_arm_;

  // From the edit thread to the haptic thread.
  struct NumberedModel {
    ForceModel model;
    std::uint64_t number = 0;
  };
  LatestValue<NumberedModel> models_;
  std::uint64_t published_ = 0;  // number of the newest model; of the edit thread
  std::atomic<std::int64_t> heartbeat_ns_{kNever};
  std::atomic<bool> arm_asked_{false};
  std::atomic<bool> disarm_asked_{false};
  std::atomic<double> strength_asked_{1.0};
  std::atomic<std::int64_t> session_offset_ns_{0};
  static_assert(std::atomic<double>::is_always_lock_free);

  // The haptic thread alone uses these.
  SafetyChain chain_;
  std::unique_ptr<LeapFilter> leaps_;
  NumberedModel current_;
  ForceMemory memory_;
  NumberedModel outgoing_;  // the model that fades out, while fade_ < 1
  ForceMemory outgoing_memory_;
  double fade_ = 1.0;         // weight of current_
  bool model_waits_ = false;  // models_.get() has not been applied yet
  std::int64_t received_ns_ = kNever;
  std::int64_t last_tick_ns_ = kNever;
  TickReport report_;
  LoopStats stats_;

  // From the haptic thread to the edit thread and the autosave.
  std::atomic<std::uint64_t> oldest_in_use_{0};
  LatestValue<TickReport> reports_;
  Ring edit_ring_;
  Ring autosave_ring_;
  const std::unique_ptr<ForceRing> force_ring_;
};

}  // namespace felt
