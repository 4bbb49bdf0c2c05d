#pragma once

#include <atomic>
#include <cstdint>
#include <string>
#include <thread>

#include "felt/base/result.h"
#include "felt/rt/device.h"
#include "felt/rt/latest_value.h"
#include "felt/rt/loop_stats.h"
#include "felt/rt/servo.h"

namespace felt {

/// What the system allowed the loop's thread to be.
enum class LoopScheduling : std::uint8_t {
  kNotRunning,
  kFifo,      ///< SCHED_FIFO: nothing ordinary comes before it
  kNice,      ///< ordinary, timers without slack, nice -20: usually on time
  kOrdinary,  ///< ordinary, timers without slack: late whenever the machine is busy
  kHost,      ///< the device's own servo loop calls (LoopHost); its maker decides how
};

struct RealtimeStatus {
  LoopScheduling scheduling = LoopScheduling::kNotRunning;
  bool memory_locked = false;  ///< no page of the program leaves memory
  /// No tick for half a second though it runs: the device, or the loop of its maker, hangs. What it
  /// does with the last force is then its own affair: tell the user, stop, and open it anew.
  bool is_silent = false;
};

/// One sentence for a person, with what would help where something was refused.
std::string describe(const RealtimeStatus& status);

struct RealtimeOptions {
  /// Ask for SCHED_FIFO with this priority, 1..99; 0 does not ask.
  int fifo_priority = 80;
  /// Ask to keep the whole program in memory, for its life: it stays so after stop().
  bool lock_memory = true;
  /// Measure the CPU time of each tick: two system calls more a tick.
  bool measure_cpu = false;
  /// How long start() waits for a host's first tick, and stop() for its last one.
  std::int64_t host_patience_ns = 2'000'000'000;
  /// How long stop() waits for our own thread to end: it may stand in a maker's call for ever.
  std::int64_t stop_patience_ns = 2'000'000'000;
};

/// Runs a servo at its period on a thread of its own, as much in real time as the system permits
/// (performance 4.1), or, given a host, on the host's thread whenever that calls. Sleeps until
/// absolute deadlines and never spins: a spinning SCHED_FIFO thread is stopped by the kernel for 50
/// ms in each second. Periods that passed while the thread was not scheduled are counted as missed
/// and left out, never caught up with.
///
///   RealtimeThread loop(servo, {});
///   if (auto started = loop.start(); !started) ...   // only when there is no thread to be had
///   status_bar(describe(loop.status()));
///   servo.heartbeat(loop.now_ns()); ...
///   if (!loop.stop()) ...                            // zero force; false: the device hangs
///
/// With a host there is neither thread nor deadline here: lateness is against one period after the
/// tick before, and the servo is stopped on the host's thread, in a tick of its own, so that the
/// device's last words are within what its maker allows; only when the host calls no more, on the
/// edit thread after it has let go.
///
/// All functions: edit thread, except now_ns().
class RealtimeThread {
 public:
  /// The servo, and the host where there is one (DriverDevice::loop_host()), must outlive it.
  RealtimeThread(Servo& servo, const RealtimeOptions& options, LoopHost* host = nullptr);
  RealtimeThread(const RealtimeThread&) = delete;
  RealtimeThread& operator=(const RealtimeThread&) = delete;
  /// Stops it. Where a tick hangs it waits for that, for ever if need be, since the loop still uses
  /// what would go: whoever may not wait calls stop() first, and abandons everything where that
  /// says false.
  ~RealtimeThread();

  /// Returns once the loop is set up, with a host after its first tick. Refused permissions are no
  /// error: status() tells. Error: there is no thread to be had; the host refuses (in the maker's
  /// words) or does not call in `host_patience_ns`. Nothing runs then.
  Result<void> start();
  /// Ends the loop: zero force, Device::stop(). Returns within a period and a tick, or whenever the
  /// device's own transfer ends; with a host that calls no more, after `host_patience_ns`. Nothing
  /// when it does not run.
  ///
  /// False: a tick still hangs in a call of the device's maker after `stop_patience_ns` (with a
  /// host: `host_patience_ns`). The end stays asked for: should that call ever come back, the loop
  /// takes the force away and ends by itself. Until then it uses this object, the servo, the device
  /// and the host, none of which may be destroyed: give them up for good with abandon()
  /// (felt/rt/abandon.h), or call stop() again later.
  [[nodiscard]] bool stop() noexcept;

  /// Lets the loop sleep, without a tick or a wake-up, until resume(): while nothing moves a
  /// pointer there is nothing to read. Only for a device without motors: nobody watches the forces
  /// meanwhile. Does nothing with a host. A loop that is stopped is not paused any more.
  void pause() noexcept;
  /// The next tick comes within a period, at a time when it would have come without the pause. Call
  /// Servo::heartbeat() first, or the edit side seems to have been silent.
  void resume() noexcept;
  [[nodiscard]] bool is_paused() const noexcept {
    return pause_asked_.load(std::memory_order_relaxed);
  }

  [[nodiscard]] bool is_running() const noexcept {
    return thread_.joinable() || is_detached_ || is_hosted_;
  }
  [[nodiscard]] RealtimeStatus status() const noexcept;
  /// The loop's clock: ns since this object was made, monotonic. Any thread.
  [[nodiscard]] std::int64_t now_ns() const noexcept;
  /// When the first tick of the last start() was due, on that clock; the others are due whole
  /// periods later (with a host: when its first tick came, and about as much later). Whoever waits
  /// for a tick's sample sets a timer by it: the loop itself wakes nobody.
  [[nodiscard]] std::int64_t first_due_ns() const noexcept { return first_due_ns_; }
  /// How the loop kept its deadlines; while it runs, as of at most 0.2 s ago. Of the last start().
  [[nodiscard]] const LoopStats& stats() noexcept;

 private:
  static constexpr std::int64_t kNever = -1;
  enum class Hosted : std::uint8_t { kTicking, kLastTick, kDone };

  void run() noexcept;
  void set_up() noexcept;
  void loop() noexcept;
  [[nodiscard]] std::int64_t sleep_until_resumed(std::int64_t deadline_ns) const noexcept;
  std::int64_t wait_for(std::int64_t deadline_ns) const noexcept;
  void tick(std::int64_t now_ns, std::int64_t late_ns) noexcept;
  Result<void> start_hosted();
  bool stop_thread() noexcept;
  bool stop_hosted() noexcept;
  void hosted_tick() noexcept;
  void step_hosted() noexcept;
  template <class Condition>
  bool wait_until(std::int64_t patience_ns, Condition condition) const;

  Servo& servo_;
  RealtimeOptions options_;
  LoopHost* host_;
  std::int64_t epoch_ns_;
  std::int64_t first_due_ns_ = 0;
  RealtimeStatus status_;
  bool is_hosted_ = false;
  bool is_detached_ = false;  // it hangs; whether it has ended since, has_ended_ tells
  std::atomic<bool> is_set_up_{false};
  std::atomic<bool> stop_asked_{false};
  std::atomic<bool> pause_asked_{false};
  std::atomic<bool> has_ended_{false};   // our own thread: it will touch nothing any more
  std::atomic<bool> is_in_tick_{false};  // the host's
  std::atomic<Hosted> hosted_{Hosted::kDone};
  std::atomic<std::int64_t> ticked_ns_{kNever};  // when the last tick began
  std::atomic<std::int64_t> resumed_ns_{kNever};
  LatestValue<LoopStats> stats_;
  // The loop's own.
  LoopStats own_stats_;
  std::int64_t next_stats_ns_ = 0;
  std::thread thread_;
};

}  // namespace felt
