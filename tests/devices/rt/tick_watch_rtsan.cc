// The program rt_proof_rtsan is watched by RealtimeSanitizer, which RealtimeScope switches on and
// off. The sanitizer prints its own message and ends the program itself.
#include <cstdio>
#include <cstdlib>

#include "tests/devices/rt/tick_watch.h"

namespace felt::rt_test {

void install_watch() {}
void touch_code() {}
bool sees_raw_system_calls() noexcept {
  return false;
}
void begin_watch() noexcept {}
void end_watch() noexcept {}
void report_violation(const char* what) noexcept {
  std::fprintf(stderr, "rt_proof: VIOLATION in a tick: %s\n", what);
  std::_Exit(3);
}

}  // namespace felt::rt_test
