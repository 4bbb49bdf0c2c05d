#pragma once

/// Watches a tick from outside: what it calls (interposer.cc stands in front of libc), which system
/// calls it makes in whatever way (the kernel's syscall user dispatch), which pages it touches for
/// the first time, and whether it gives the processor away.
namespace felt::rt_test {

/// Once, on the thread that will tick. Says on stderr what this system cannot watch.
void install_watch();
/// Touches what is mapped from files, so that code which runs for the first time at a tick, in an
/// error say, is no page fault: of that a program cannot be the cause. Not the heap and the stack.
void touch_code();
/// False where system calls that bypass libc cannot be seen.
bool sees_raw_system_calls() noexcept;

/// From here to end_watch() the thread must make no system call. A violation ends the program with
/// exit code 3 and a message that names it.
void begin_watch() noexcept;
void end_watch() noexcept;

/// A violation: message, call stack, exit code 3.
[[noreturn]] void report_violation(const char* what) noexcept;

}  // namespace felt::rt_test
