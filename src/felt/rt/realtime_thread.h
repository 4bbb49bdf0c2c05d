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

/// The scheduling that the system granted the loop's thread.
enum class LoopScheduling : std::uint8_t {
  kNotRunning,
  kFifo,      ///< SCHED_FIFO: runs before all ordinary threads
  kNice,      ///< ordinary, no timer slack, nice -20: usually on time
  kOrdinary,  ///< ordinary, no timer slack: late when the machine is busy
  kHost,      ///< called by the device's own servo loop (LoopHost), which decides the scheduling
};

struct RealtimeStatus {
  LoopScheduling scheduling = LoopScheduling::kNotRunning;
  bool memory_locked = false;  ///< no page of the program is swapped out
  /// The loop runs, but its last tick was more than half a second ago: the device or the vendor's
  /// loop is unresponsive. Feltline cannot control what the device then does with the last force.
  /// Tell the user, stop, and open the device again.
  bool is_silent = false;
};

/// Returns one sentence for the user. If the system refused something, the sentence says what would
/// help.
std::string describe(const RealtimeStatus& status);

struct RealtimeOptions {
  /// Request SCHED_FIFO with this priority, 1..99; 0 leaves the scheduling as it is.
  int fifo_priority = 80;
  /// Request to lock the whole program in memory. The memory stays locked until the program ends,
  /// even after stop().
  bool lock_memory = true;
  /// Measure the CPU time of each tick, which costs two more system calls per tick.
  bool measure_cpu = false;
  /// Time that start() waits for a host's first tick, and stop() for its last tick.
  std::int64_t host_patience_ns = 2'000'000'000;
  /// Time that stop() waits for the loop's own thread to end. That thread may be blocked forever in
  /// a call of the vendor's driver.
  std::int64_t stop_patience_ns = 2'000'000'000;
};

/// Runs a servo at its period on a thread of its own, as close to real time as the system permits
/// (docs/design/loop.md#wake-up-lateness). If the device has a host (LoopHost), the servo runs on
/// the host's thread whenever the host calls. Its own thread sleeps until absolute deadlines and
/// never spins, because the kernel stops a spinning SCHED_FIFO thread for 50 ms in each second.
/// Periods that passed while the thread was not scheduled are counted as missed and skipped, not
/// caught up.
///
///   RealtimeThread loop(servo, {});
///   if (auto started = loop.start(); !started) ...   // fails only if no thread can be started
///   status_bar(describe(loop.status()));
///   servo.heartbeat(loop.now_ns()); ...
///   if (!loop.stop()) ...                            // sets zero force; false if the device hangs
///
/// With a host, this object has neither a thread nor deadlines: lateness is relative to one period
/// after the previous tick. The servo is then stopped on the host's thread, in a last tick, so that
/// the device's last call comes from the thread that the vendor requires. If the host no longer
/// calls, the servo is stopped on the edit thread, after the host's loop has been stopped.
///
/// Call all functions on the edit thread, except now_ns().
class RealtimeThread {
 public:
  /// Makes a loop that does not run yet. The servo, and the host if the device has one
  /// (DriverDevice::loop_host()), must outlive the loop.
  RealtimeThread(Servo& servo, const RealtimeOptions& options, LoopHost* host = nullptr);
  RealtimeThread(const RealtimeThread&) = delete;
  RealtimeThread& operator=(const RealtimeThread&) = delete;
  /// Stops the loop. If a tick hangs, the destructor waits for it, possibly forever, because the
  /// loop still uses the objects that would be destroyed. If you cannot wait, call stop() first,
  /// and abandon everything if it returns false.
  ~RealtimeThread();

  /// Starts the loop. Returns when the loop is set up; with a host, after its first tick. Refused
  /// permissions are not an error; see status(). Fails if no thread can be started, if the host
  /// refuses (with the vendor's message), or if the host does not call within `host_patience_ns`.
  /// After a failure the loop does not run.
  Result<void> start();
  /// Ends the loop: sets the force to zero and calls Device::stop(). Returns within the duration of
  /// a period and a tick, or when the device's current transfer ends, if that takes longer. If a
  /// host no longer calls, returns after `host_patience_ns`. Has no effect if the loop does not
  /// run.
  ///
  /// Returns false if a tick still hangs in a call of the vendor's driver after `stop_patience_ns`
  /// (with a host: `host_patience_ns`). The request to end remains: if that call ever returns, the
  /// loop sets the force to zero and ends by itself. Until then the loop uses this object, the
  /// servo, the device and the host, so do not destroy them: either abandon() them
  /// (felt/rt/abandon.h), or call stop() again later.
  [[nodiscard]] bool stop() noexcept;

  /// Lets the loop sleep, without ticks or wake-ups, until resume(). Use it while no pointer moves,
  /// and only for a device without motors, because nothing monitors the forces during the pause.
  /// Has no effect with a host. Stopping the loop ends the pause.
  void pause() noexcept;
  /// Ends the pause. The next tick comes within a period, at a time at which a tick would have come
  /// without the pause. Call Servo::heartbeat() before resume(); otherwise the edit thread seems to
  /// have been silent.
  void resume() noexcept;
  [[nodiscard]] bool is_paused() const noexcept {
    return pause_asked_.load(std::memory_order_relaxed);
  }

  [[nodiscard]] bool is_running() const noexcept {
    return thread_.joinable() || is_detached_ || is_hosted_;
  }
  [[nodiscard]] RealtimeStatus status() const noexcept;
  /// Returns the time of the loop's clock: ns since this object was made, monotonic. Safe to call
  /// from any thread.
  [[nodiscard]] std::int64_t now_ns() const noexcept;
  /// Returns the time, on the loop's clock, at which the first tick after the last start() was due.
  /// All other ticks are due whole periods later. With a host, returns the time of its first tick;
  /// the others come about whole periods later. Code that waits for the sample of a tick sets a
  /// timer from this time, because the loop itself does not wake any other thread.
  [[nodiscard]] std::int64_t first_due_ns() const noexcept { return first_due_ns_; }
  /// Returns the statistics of how the loop kept its deadlines since the last start(). While the
  /// loop runs, they are at most 0.2 s old.
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
  bool is_detached_ =
      false;  // the thread's tick hangs; has_ended_ says if the thread has ended since
  std::atomic<bool> is_set_up_{false};
  std::atomic<bool> stop_asked_{false};
  std::atomic<bool> pause_asked_{false};
  std::atomic<bool> has_ended_{false};   // the loop's own thread will not access anything any more
  std::atomic<bool> is_in_tick_{false};  // of the host's thread
  std::atomic<Hosted> hosted_{Hosted::kDone};
  std::atomic<std::int64_t> ticked_ns_{kNever};  // when the last tick began
  std::atomic<std::int64_t> resumed_ns_{kNever};
  LatestValue<LoopStats> stats_;
  // The loop alone uses these.
  LoopStats own_stats_;
  std::int64_t next_stats_ns_ = 0;
  std::thread thread_;
};

}  // namespace felt
