#include "interrupt.h"

#include <atomic>
#include <csignal>
#include <cstdint>
#include <ctime>
#include <initializer_list>

namespace felt::cli {
namespace {

volatile std::sig_atomic_t asked = 0;
volatile std::sig_atomic_t pause_asked = 0;

// Two signals within this time count as one request, because timeout(1) sends the signal to the
// program and immediately afterwards to its process group.
constexpr std::int64_t kSameWishNs = 300'000'000;
std::atomic<std::int64_t> asked_ns{0};
static_assert(std::atomic<std::int64_t>::is_always_lock_free);

std::int64_t now_ns() noexcept {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);  // allowed in a signal handler
  return std::int64_t{now.tv_sec} * 1'000'000'000 + now.tv_nsec;
}

extern "C" void note_interrupt(int signal) {
  if (asked == 0) asked_ns.store(now_ns());
  if (asked != 0 && signal != SIGTSTP && now_ns() - asked_ns.load() > kSameWishNs) {
    std::signal(signal, SIG_DFL);
    std::raise(signal);
  }
  asked = 1;
}

extern "C" void note_pause(int) {
  pause_asked = 1;
}

void set(void (*handler)(int), std::initializer_list<int> signals) {
  struct sigaction action {};
  action.sa_handler = handler;  // without SA_RESTART, so that a question at the terminal also ends
  sigemptyset(&action.sa_mask);
  for (const int signal : signals) sigaction(signal, &action, nullptr);
}

}  // namespace

Interrupt::Interrupt(OnSuspend on_suspend) {
  asked = 0;
  pause_asked = 0;
  set(note_interrupt, {SIGINT, SIGTERM, SIGHUP, SIGQUIT});
  set(on_suspend == OnSuspend::kPause ? note_pause : note_interrupt, {SIGTSTP});
  set(SIG_IGN, {SIGTTIN, SIGTTOU});
}

Interrupt::~Interrupt() {
  set(SIG_DFL, {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGTSTP, SIGTTIN, SIGTTOU});
}

bool Interrupt::was_asked() noexcept {
  return asked != 0;
}

bool Interrupt::wants_pause() noexcept {
  return pause_asked != 0;
}

void Interrupt::pause() noexcept {
  pause_asked = 0;
  std::raise(SIGSTOP);
}

}  // namespace felt::cli
