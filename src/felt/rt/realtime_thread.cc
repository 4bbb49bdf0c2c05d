#include "felt/rt/realtime_thread.h"

#include <linux/capability.h>
#include <pthread.h>
#include <sched.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <ctime>
#include <system_error>

namespace felt {
namespace {

constexpr std::int64_t kSecond = 1'000'000'000;
constexpr std::int64_t kStatsEvery = 100'000'000;
constexpr std::int64_t kSilentNs = 500'000'000;
constexpr std::size_t kStackBytes = 128 * 1024;  // far more than a tick uses

std::int64_t clock_ns(clockid_t clock) noexcept {
  timespec now{};
  clock_gettime(clock, &now);
  return now.tv_sec * kSecond + now.tv_nsec;
}

bool may_lock_all() noexcept {
  rlimit limit{};
  if (getrlimit(RLIMIT_MEMLOCK, &limit) == 0 && limit.rlim_cur == RLIM_INFINITY) return true;
  __user_cap_header_struct header{_LINUX_CAPABILITY_VERSION_3, 0};
  std::array<__user_cap_data_struct, _LINUX_CAPABILITY_U32S_3> data{};
  return syscall(SYS_capget, &header, data.data()) == 0 &&
         (data[0].effective & (1U << CAP_IPC_LOCK)) != 0;
}

// Locks all memory unless the system limits locked memory. With such a limit and MCL_FUTURE, any
// allocation of the program beyond the limit would fail. MCL_ONFAULT locks pages when they are
// first used, so that idle stacks stay small.
bool lock_memory() noexcept {
  return may_lock_all() && mlockall(MCL_CURRENT | MCL_FUTURE | MCL_ONFAULT) == 0;
}

[[gnu::noinline]] void touch_stack() noexcept {
  std::array<char, kStackBytes> stack{};
  asm volatile("" : : "r"(stack.data()) : "memory");  // keeps the array
}

LoopScheduling schedule(int fifo_priority) noexcept {
  sched_param wanted{};
  wanted.sched_priority = std::min(fifo_priority, sched_get_priority_max(SCHED_FIFO));
  if (fifo_priority > 0 && pthread_setschedparam(pthread_self(), SCHED_FIFO, &wanted) == 0) {
    return LoopScheduling::kFifo;
  }
  prctl(PR_SET_TIMERSLACK, 1UL, 0UL, 0UL, 0UL);  // for this thread; needs no permission
  // On Linux the nice value belongs to the thread, too.
  const auto thread = static_cast<id_t>(syscall(SYS_gettid));
  return setpriority(PRIO_PROCESS, thread, -20) == 0 ? LoopScheduling::kNice
                                                     : LoopScheduling::kOrdinary;
}

}  // namespace

std::string describe(const RealtimeStatus& status) {
  std::string text;
  if (status.is_silent) {
    return "The haptic loop stands still: the device, or its maker's software, does not answer; "
           "close it, connect it again and open it again.";
  }
  switch (status.scheduling) {
    case LoopScheduling::kNotRunning:
      return "The haptic loop is not running.";
    case LoopScheduling::kFifo:
      text = "The haptic loop runs in real time (SCHED_FIFO)";
      break;
    case LoopScheduling::kNice:
      text =
          "The haptic loop runs with raised priority (nice -20), because SCHED_FIFO is not "
          "permitted";
      break;
    case LoopScheduling::kOrdinary:
      text =
          "The haptic loop runs as an ordinary thread and will be late when the machine is busy;"
          " allow real time for your user by rtprio in /etc/security/limits.d";
      break;
    case LoopScheduling::kHost:
      text = "The haptic loop is run by the device's software";
      break;
  }
  text += status.memory_locked ? ", with its memory locked."
                               : "; its memory may be swapped out (memlock is limited).";
  return text;
}

RealtimeThread::RealtimeThread(Servo& servo, const RealtimeOptions& options, LoopHost* host)
    : servo_(servo), options_(options), host_(host), epoch_ns_(clock_ns(CLOCK_MONOTONIC)) {}

RealtimeThread::~RealtimeThread() {
  while (!stop()) {
  }
}

std::int64_t RealtimeThread::now_ns() const noexcept {
  return clock_ns(CLOCK_MONOTONIC) - epoch_ns_;
}

RealtimeStatus RealtimeThread::status() const noexcept {
  RealtimeStatus status = status_;
  if (!is_running() || is_paused()) return status;
  const std::int64_t ticked_ns = ticked_ns_.load(std::memory_order_relaxed);
  const std::int64_t resumed_ns = resumed_ns_.load(std::memory_order_relaxed);
  status.is_silent = now_ns() - std::max({ticked_ns, first_due_ns_, resumed_ns}) > kSilentNs;
  return status;
}

const LoopStats& RealtimeThread::stats() noexcept {
  stats_.update();
  return stats_.get();
}

Result<void> RealtimeThread::start() {
  if (is_running()) return {};
  stop_asked_.store(false, std::memory_order_relaxed);
  pause_asked_.store(false, std::memory_order_relaxed);
  is_set_up_.store(false, std::memory_order_relaxed);
  has_ended_.store(false, std::memory_order_relaxed);
  ticked_ns_.store(kNever, std::memory_order_relaxed);
  resumed_ns_.store(kNever, std::memory_order_relaxed);
  own_stats_ = {};
  next_stats_ns_ = 0;
  if (host_ != nullptr) return start_hosted();
  try {
    thread_ = std::thread([this] { run(); });
  } catch (const std::system_error& error) {
    return fail(ErrorCode::kUnsupported,
                std::string("the thread of the haptic loop could not be started: ") + error.what());
  }
  is_set_up_.wait(false, std::memory_order_acquire);
  return {};
}

bool RealtimeThread::stop() noexcept {
  if (!is_running()) return true;
  if (!(is_hosted_ ? stop_hosted() : stop_thread())) return false;
  status_ = {};
  return true;
}

bool RealtimeThread::stop_thread() noexcept {
  stop_asked_.store(true, std::memory_order_relaxed);
  resume();
  const auto has_ended = [this] { return has_ended_.load(std::memory_order_acquire); };
  if (!wait_until(options_.stop_patience_ns, has_ended)) {
    if (thread_.joinable()) thread_.detach();
    is_detached_ = true;
    return false;
  }
  if (thread_.joinable()) thread_.join();
  is_detached_ = false;
  return true;
}

void RealtimeThread::run() noexcept {
  set_up();
  is_set_up_.store(true, std::memory_order_release);
  is_set_up_.notify_one();
  loop();
  servo_.stop();
  has_ended_.store(true, std::memory_order_release);
}

void RealtimeThread::set_up() noexcept {
  status_.scheduling = schedule(options_.fifo_priority);
  status_.memory_locked = options_.lock_memory && lock_memory();
  touch_stack();
  first_due_ns_ = now_ns() + servo_.options().period_ns;
}

// Sleeps until the deadline and returns the time at which the thread woke.
std::int64_t RealtimeThread::wait_for(std::int64_t deadline_ns) const noexcept {
  const std::int64_t at_ns = epoch_ns_ + deadline_ns;
  timespec until{};
  until.tv_sec = at_ns / kSecond;
  until.tv_nsec = at_ns % kSecond;
  while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &until, nullptr) == EINTR) {
  }
  return now_ns();
}

void RealtimeThread::tick(std::int64_t now_ns, std::int64_t late_ns) noexcept {
  const std::int64_t cpu_ns = options_.measure_cpu ? clock_ns(CLOCK_THREAD_CPUTIME_ID) : 0;
  ticked_ns_.store(now_ns, std::memory_order_release);
  servo_.step(now_ns);
  if (options_.measure_cpu) own_stats_.add_cpu(clock_ns(CLOCK_THREAD_CPUTIME_ID) - cpu_ns);
  own_stats_.tick(now_ns, late_ns, servo_.options().period_ns);
  if (now_ns < next_stats_ns_) return;
  stats_.publish(own_stats_);
  next_stats_ns_ = now_ns + kStatsEvery;
}

void RealtimeThread::loop() noexcept {
  const std::int64_t period_ns = servo_.options().period_ns;
  std::int64_t deadline_ns = first_due_ns_;
  while (!stop_asked_.load(std::memory_order_relaxed)) {
    if (pause_asked_.load(std::memory_order_acquire)) {
      const std::int64_t due_ns = deadline_ns;
      deadline_ns = sleep_until_resumed(due_ns);
      own_stats_.leave_out(deadline_ns - due_ns);
      continue;
    }
    const std::int64_t woke_ns = wait_for(deadline_ns);
    const std::int64_t late_ns = woke_ns - deadline_ns;
    tick(woke_ns, late_ns);
    deadline_ns += period_ns * (1 + std::max<std::int64_t>(late_ns, 0) / period_ns);
  }
  stats_.publish(own_stats_);
}

// Sleeps until resume(). It is called between two ticks, so that nothing in a tick blocks. Returns
// the deadline of the next tick, a whole number of periods after the given one, so that
// first_due_ns() remains valid.
std::int64_t RealtimeThread::sleep_until_resumed(std::int64_t deadline_ns) const noexcept {
  const std::int64_t period_ns = servo_.options().period_ns;
  pause_asked_.wait(true, std::memory_order_acquire);
  const std::int64_t passed_ns = now_ns() - deadline_ns;
  return passed_ns <= 0 ? deadline_ns : deadline_ns + period_ns * (1 + passed_ns / period_ns);
}

void RealtimeThread::pause() noexcept {
  if (!host_ && is_running()) pause_asked_.store(true, std::memory_order_release);
}

void RealtimeThread::resume() noexcept {
  if (is_paused()) resumed_ns_.store(now_ns(), std::memory_order_relaxed);
  pause_asked_.store(false, std::memory_order_release);
  pause_asked_.notify_one();
}

// Polls the condition. Returns false if it is still false after `patience_ns`. It polls because the
// haptic thread does not wake other threads. Edit thread only.
template <class Condition>
bool RealtimeThread::wait_until(std::int64_t patience_ns, Condition condition) const {
  const std::int64_t until_ns = now_ns() + patience_ns;
  while (!condition()) {
    if (now_ns() >= until_ns) return false;
    static_cast<void>(wait_for(now_ns() + kSecond / 1000));
  }
  return true;
}

Result<void> RealtimeThread::start_hosted() {
  status_ = {.scheduling = LoopScheduling::kHost,
             .memory_locked = options_.lock_memory && lock_memory()};
  hosted_.store(Hosted::kTicking, std::memory_order_relaxed);
  const Result<void> started = host_->start_loop(
      [](void* self) noexcept { static_cast<RealtimeThread*>(self)->hosted_tick(); }, this);
  if (!started) {
    status_ = {};
    return started;
  }
  is_hosted_ = true;
  if (wait_until(options_.host_patience_ns,
                 [this] { return ticked_ns_.load(std::memory_order_acquire) != kNever; })) {
    return {};
  }
  static_cast<void>(stop());  // no tick was in progress
  return fail(ErrorCode::kIo,
              "the device's software started its haptic loop, but does not run it: disconnect the "
              "device, connect it again and open it again");
}

bool RealtimeThread::stop_hosted() noexcept {
  // An earlier stop() may have failed to end the loop, and the loop may have ended since.
  if (hosted_.load(std::memory_order_acquire) == Hosted::kTicking) {
    hosted_.store(Hosted::kLastTick, std::memory_order_relaxed);
  }
  const auto is_done = [this] { return hosted_.load(std::memory_order_acquire) == Hosted::kDone; };
  // If the host has never called, it will probably not call now.
  if (ticked_ns_.load(std::memory_order_relaxed) != kNever) {
    wait_until(options_.host_patience_ns, is_done);
  }
  // stop_loop() would wait forever for the tick in progress, and the tick uses the servo until it
  // ends.
  if (!is_done() && is_in_tick_.load(std::memory_order_acquire)) return false;
  host_->stop_loop();
  if (!is_done()) servo_.stop();
  hosted_.store(Hosted::kDone, std::memory_order_relaxed);
  stats_.publish(own_stats_);
  is_hosted_ = false;
  return true;
}

void RealtimeThread::hosted_tick() noexcept {
  is_in_tick_.store(true, std::memory_order_release);
  step_hosted();
  is_in_tick_.store(false, std::memory_order_release);
}

void RealtimeThread::step_hosted() noexcept {
  const Hosted state = hosted_.load(std::memory_order_acquire);
  if (state == Hosted::kDone) return;
  if (state == Hosted::kLastTick) {
    servo_.stop();
    hosted_.store(Hosted::kDone, std::memory_order_release);
    return;
  }
  const std::int64_t now = now_ns();
  const std::int64_t last_ns = ticked_ns_.load(std::memory_order_relaxed);
  const std::int64_t period_ns = servo_.options().period_ns;
  if (last_ns == kNever) first_due_ns_ = now;
  tick(now, last_ns == kNever ? 0 : now - last_ns - period_ns);
}

}  // namespace felt
