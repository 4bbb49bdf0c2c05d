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

// Not under a limit: once all future pages are to be locked, an allocation beyond the limit fails,
// anywhere in the program. Pages are locked as they are first used, so that idle stacks stay small.
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
  prctl(PR_SET_TIMERSLACK, 1UL, 0UL, 0UL, 0UL);  // of this thread; everybody may
  // On Linux the nice value belongs to the thread, too.
  const auto thread = static_cast<id_t>(syscall(SYS_gettid));
  return setpriority(PRIO_PROCESS, thread, -20) == 0 ? LoopScheduling::kNice
                                                     : LoopScheduling::kOrdinary;
}

}  // namespace

std::string describe(const RealtimeStatus& status) {
  std::string text;
  switch (status.scheduling) {
    case LoopScheduling::kNotRunning:
      return "The haptic loop is not running.";
    case LoopScheduling::kFifo:
      text = "The haptic loop runs in real time (SCHED_FIFO)";
      break;
    case LoopScheduling::kNice:
      text = "The haptic loop runs with raised priority (nice -20), as SCHED_FIFO is not permitted";
      break;
    case LoopScheduling::kOrdinary:
      text =
          "The haptic loop runs as an ordinary thread and will be late when the machine is busy;"
          " allow real time for your user by rtprio in /etc/security/limits.d";
      break;
  }
  text += status.memory_locked ? ", with its memory locked."
                               : "; its memory may be swapped out (memlock is limited).";
  return text;
}

RealtimeThread::RealtimeThread(Servo& servo, const RealtimeOptions& options)
    : servo_(servo), options_(options), epoch_ns_(clock_ns(CLOCK_MONOTONIC)) {}

RealtimeThread::~RealtimeThread() {
  stop();
}

std::int64_t RealtimeThread::now_ns() const noexcept {
  return clock_ns(CLOCK_MONOTONIC) - epoch_ns_;
}

const LoopStats& RealtimeThread::stats() noexcept {
  stats_.update();
  return stats_.get();
}

Result<void> RealtimeThread::start() {
  if (is_running()) return {};
  stop_asked_.store(false, std::memory_order_relaxed);
  is_set_up_.store(false, std::memory_order_relaxed);
  try {
    thread_ = std::thread([this] { run(); });
  } catch (const std::system_error& error) {
    return fail(ErrorCode::kUnsupported,
                std::string("the haptic loop got no thread: ") + error.what());
  }
  is_set_up_.wait(false, std::memory_order_acquire);
  return {};
}

void RealtimeThread::stop() noexcept {
  if (!is_running()) return;
  stop_asked_.store(true, std::memory_order_relaxed);
  thread_.join();
  status_ = {};
}

void RealtimeThread::run() noexcept {
  set_up();
  is_set_up_.store(true, std::memory_order_release);
  is_set_up_.notify_one();
  loop();
  servo_.stop();
}

void RealtimeThread::set_up() noexcept {
  status_.scheduling = schedule(options_.fifo_priority);
  status_.memory_locked = options_.lock_memory && lock_memory();
  touch_stack();
  first_due_ns_ = now_ns() + servo_.options().period_ns;
}

// Returns the time at which it woke.
std::int64_t RealtimeThread::wait_for(std::int64_t deadline_ns) const noexcept {
  const std::int64_t at_ns = epoch_ns_ + deadline_ns;
  timespec until{};
  until.tv_sec = at_ns / kSecond;
  until.tv_nsec = at_ns % kSecond;
  while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &until, nullptr) == EINTR) {
  }
  return now_ns();
}

void RealtimeThread::loop() noexcept {
  const std::int64_t period_ns = servo_.options().period_ns;
  LoopStats stats;
  std::int64_t next_stats_ns = 0;
  std::int64_t deadline_ns = first_due_ns_;
  while (!stop_asked_.load(std::memory_order_relaxed)) {
    const std::int64_t woke_ns = wait_for(deadline_ns);
    const std::int64_t cpu_ns = options_.measure_cpu ? clock_ns(CLOCK_THREAD_CPUTIME_ID) : 0;
    servo_.step(woke_ns);
    if (options_.measure_cpu) stats.add_cpu(clock_ns(CLOCK_THREAD_CPUTIME_ID) - cpu_ns);
    const std::int64_t late_ns = woke_ns - deadline_ns;
    stats.tick(woke_ns, late_ns, period_ns);
    deadline_ns += period_ns * (1 + std::max<std::int64_t>(late_ns, 0) / period_ns);
    if (woke_ns >= next_stats_ns) {
      stats_.publish(stats);
      next_stats_ns = woke_ns + kStatsEvery;
    }
  }
  stats_.publish(stats);
}

}  // namespace felt
