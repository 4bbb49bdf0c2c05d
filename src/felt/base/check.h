#pragma once

/// Checks for programmer errors (docs/decisions/0001-expected-for-errors.md). They are active in
/// every build; the haptic tick does not use them. Bad data and faulty devices are not programmer
/// errors; they are reported as `Result`.

namespace felt::detail {

/// Prints the failed condition with its file and line to stderr and aborts.
[[noreturn]] void check_failed(const char* condition, const char* file, int line) noexcept;

}  // namespace felt::detail

/// Aborts with file and line if `condition` is false.
#define FELT_CHECK(condition)         \
  ((condition) ? static_cast<void>(0) \
               : ::felt::detail::check_failed(#condition, __FILE__, __LINE__))
