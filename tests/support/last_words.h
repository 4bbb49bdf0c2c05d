#pragma once

#include <unistd.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <cstddef>
#include <cstring>
#include <initializer_list>
#include <string_view>

/// For programs that try random cases: if a case crashes or hangs, the program prints the command
/// line that repeats it.
namespace felt::last_words {

/// The command line that repeats the current case. It is stored in advance because a signal handler
/// may call only few functions.
struct RepeatLine {
  std::array<char, 512> text{};
  std::size_t length = 0;
};
inline RepeatLine repeat_line;

/// Sets the current case, with the command line that repeats it. If the case takes longer than
/// `hangs_after_s` seconds, reports that it hangs and ends the program.
inline void watch(std::string_view repeat, unsigned hangs_after_s) {
  repeat_line.length = std::min(repeat.size(), repeat_line.text.size());
  std::memcpy(repeat_line.text.data(), repeat.data(), repeat_line.length);
  alarm(hangs_after_s);
}

/// Returns the command line given to watch(), cut at 512 characters.
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

/// Installs signal handlers: if the program crashes or hangs, its last output is "broken rule:
/// crashes: " or "broken rule: hangs: " and the command line. The handlers have a separate stack,
/// because a crash may be an overflow of the usual one.
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
