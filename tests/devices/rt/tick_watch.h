#pragma once

/// Watches a tick from outside. Detects calls of forbidden libc functions (interposer.cc replaces
/// them), all system calls, even those that bypass libc (the kernel's syscall user dispatch), first
/// accesses to memory pages, and voluntary context switches.
namespace felt::rt_test {

/// Installs the watch. Call once, on the thread that will run the ticks. Prints to stderr what this
/// system cannot watch.
void install_watch();
/// Touches all pages that are mapped from files, but not the heap and the stack. Without this, code
/// that runs for the first time at a tick, for example for an error, would cause a page fault. That
/// fault would not be a mistake of the tick.
void touch_code();
/// Returns false if the watch cannot see system calls that bypass libc.
bool sees_raw_system_calls() noexcept;

/// Starts the watch: until end_watch() the calling thread must not make any system call. A
/// violation ends the program with exit code 3 and a message that names the call.
void begin_watch() noexcept;
/// Ends the watch. Reports page faults and voluntary context switches since begin_watch() as
/// violations.
void end_watch() noexcept;

/// Reports the violation `what`: prints a message and the call stack, then exits with code 3.
[[noreturn]] void report_violation(const char* what) noexcept;

}  // namespace felt::rt_test
