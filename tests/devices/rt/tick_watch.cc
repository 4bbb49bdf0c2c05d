#include "tests/devices/rt/tick_watch.h"

#include <csignal>
#include <cstdio>
#include <cstring>

#include <execinfo.h>
#include <linux/prctl.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

#include "felt/rt/realtime_scope.h"

namespace felt::rt_test {
namespace {

// The kernel reads this at every system call of the thread.
volatile char gate = 0;  // SYSCALL_DISPATCH_FILTER_ALLOW
bool has_gate = false;
rusage before{};

void on_system_call(int, siginfo_t* info, void*) {
  gate = 0;
  char text[64];
  std::snprintf(text, sizeof text, "system call %d", info->si_syscall);
  report_violation(text);
}

}  // namespace

void install_watch() {
#ifdef PR_SET_SYSCALL_USER_DISPATCH
  struct sigaction action {};
  action.sa_sigaction = on_system_call;
  action.sa_flags = SA_SIGINFO;
  has_gate = sigaction(SIGSYS, &action, nullptr) == 0 &&
             prctl(PR_SET_SYSCALL_USER_DISPATCH, PR_SYS_DISPATCH_ON, 0UL, 0UL, &gate) == 0;
#endif
  if (!has_gate) {
    std::fprintf(stderr, "rt_proof: this kernel cannot watch system calls; libc's are watched\n");
  }
  void* frame = nullptr;
  backtrace(&frame, 1);  // makes it load its library now and not during a violation
}

void touch_code() {
  std::FILE* maps = std::fopen("/proc/self/maps", "r");
  if (maps == nullptr) return;
  char line[512];
  while (std::fgets(line, sizeof line, maps) != nullptr) {
    unsigned long from = 0, until = 0;
    char rights[8] = "";
    if (std::sscanf(line, "%lx-%lx %7s", &from, &until, rights) != 3) continue;
    if (rights[0] != 'r' || std::strchr(line, '/') == nullptr) continue;
    for (unsigned long at = from; at < until; at += 4096) {
      auto* byte = reinterpret_cast<volatile char*>(at);
      const char value = *byte;
      if (rights[1] == 'w') *byte = value;
    }
  }
  std::fclose(maps);
}

bool sees_raw_system_calls() noexcept {
  return has_gate;
}

void begin_watch() noexcept {
  getrusage(RUSAGE_THREAD, &before);
  if (has_gate) gate = 1;  // SYSCALL_DISPATCH_FILTER_BLOCK
}

void end_watch() noexcept {
  gate = 0;
  rusage after{};
  getrusage(RUSAGE_THREAD, &after);
  if (after.ru_minflt != before.ru_minflt) report_violation("page fault (minor)");
  if (after.ru_majflt != before.ru_majflt) report_violation("page fault (major)");
  if (after.ru_nvcsw != before.ru_nvcsw) report_violation("voluntary context switch");
}

void report_violation(const char* what) noexcept {
  gate = 0;
  realtime_depth = 0;
  std::fflush(stdout);
  std::fprintf(stderr, "rt_proof: VIOLATION in a tick: %s\n", what);
  void* frames[32];
  backtrace_symbols_fd(frames, backtrace(frames, 32), STDERR_FILENO);
  _exit(3);
}

}  // namespace felt::rt_test
