#pragma once

#include <atomic>
#include <cstdint>
#include <string>
#include <thread>

#include "felt/base/result.h"
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
};

struct RealtimeStatus {
  LoopScheduling scheduling = LoopScheduling::kNotRunning;
  bool memory_locked = false;  ///< no page of the program leaves memory
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
};

/// Runs a servo at its period on a thread of its own, as much in real time as the system permits
/// (performance 4.1). Sleeps until absolute deadlines and never spins: a spinning SCHED_FIFO thread
/// is stopped by the kernel for 50 ms in each second. Periods that passed while the thread was not
/// scheduled are counted as missed and left out, never caught up with.
///
///   RealtimeThread loop(servo, {});
///   if (auto started = loop.start(); !started) ...   // only when there is no thread to be had
///   status_bar(describe(loop.status()));
///   servo.heartbeat(loop.now_ns()); ...
///   loop.stop();                                     // zero force; the destructor does it too
///
/// All functions: edit thread, except now_ns().
class RealtimeThread {
 public:
  /// The servo must outlive it.
  RealtimeThread(Servo& servo, const RealtimeOptions& options);
  RealtimeThread(const RealtimeThread&) = delete;
  RealtimeThread& operator=(const RealtimeThread&) = delete;
  ~RealtimeThread();

  /// Returns once the loop is set up. Refused permissions are no error: status() tells.
  Result<void> start();
  /// Ends the loop: zero force, Device::stop(). Returns within a period and a tick, or whenever the
  /// device's own transfer ends. Nothing when it does not run.
  void stop() noexcept;

  [[nodiscard]] bool is_running() const noexcept { return thread_.joinable(); }
  [[nodiscard]] const RealtimeStatus& status() const noexcept { return status_; }
  /// The loop's clock: ns since this object was made, monotonic. Any thread.
  [[nodiscard]] std::int64_t now_ns() const noexcept;
  /// When the first tick of the last start() was due, on that clock; the others are due whole
  /// periods later. Whoever waits for a tick's sample sets a timer by it: the loop itself wakes
  /// nobody.
  [[nodiscard]] std::int64_t first_due_ns() const noexcept { return first_due_ns_; }
  /// How the loop kept its deadlines; while it runs, as of at most 0.2 s ago. Of the last start().
  [[nodiscard]] const LoopStats& stats() noexcept;

 private:
  void run() noexcept;
  void set_up() noexcept;
  void loop() noexcept;
  std::int64_t wait_for(std::int64_t deadline_ns) const noexcept;

  Servo& servo_;
  RealtimeOptions options_;
  std::int64_t epoch_ns_;
  std::int64_t first_due_ns_ = 0;
  RealtimeStatus status_;
  std::atomic<bool> is_set_up_{false};
  std::atomic<bool> stop_asked_{false};
  LatestValue<LoopStats> stats_;
  std::thread thread_;
};

}  // namespace felt
