#pragma once

#include <unistd.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <cstddef>
#include <cstring>
#include <initializer_list>
#include <string_view>

/// For programs that try random cases: a case that crashes or hangs still says how it is repeated.
namespace felt::last_words {

/// The line that repeats the present case, kept ready, since a signal handler may do little.
struct RepeatLine {
  std::array<char, 512> text{};
  std::size_t length = 0;
};
inline RepeatLine repeat_line;

/// The present case; one that takes longer than `hangs_after_s` is said to hang and ends the
/// program.
inline void watch(std::string_view repeat, unsigned hangs_after_s) {
  repeat_line.length = std::min(repeat.size(), repeat_line.text.size());
  std::memcpy(repeat_line.text.data(), repeat.data(), repeat_line.length);
  alarm(hangs_after_s);
}

/// As given to watch(), cut at 512 characters.
inline std::string_view repeat() {
  return {repeat_line.text.data(), repeat_line.length};
}

inline void say_and_die(int signal) {
  const char* what = signal == SIGALRM ? "hangs: " : "crashes: ";
  (void)!write(STDOUT_FILENO, "broken rule: ", 13);
  (void)!write(STDOUT_FILENO, what, std::strlen(what));
  (void)!write(STDOUT_FILENO, repeat_line.text.data(), repeat_line.length);
  std::signal(signal, SIG_DFL);
  if (signal == SIGALRM) _exit(1);
  std::raise(signal);
}

/// From now on the last words of the program are "broken rule: crashes: " or "hangs: " and the
/// line. On a stack of its own: the usual one may be what overflowed.
inline void watch_signals() {
  static std::array<char, 1 << 16> stack_of_its_own;
  stack_t stack{};
  stack.ss_sp = stack_of_its_own.data();
  stack.ss_size = stack_of_its_own.size();
  sigaltstack(&stack, nullptr);
  struct sigaction action {};
  action.sa_handler = say_and_die;
  action.sa_flags = SA_ONSTACK;
  for (const int signal : {SIGABRT, SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGALRM}) {
    sigaction(signal, &action, nullptr);
  }
}

}  // namespace felt::last_words
