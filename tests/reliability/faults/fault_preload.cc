// The interposer as a library for LD_PRELOAD, to test an unmodified program. The environment
// variable FELT_FAULTS names the file with the shared FaultState.
#include <fcntl.h>
#include <stdlib.h>
#include <sys/mman.h>
#include <sys/syscall.h>
#include <unistd.h>

#include "tests/reliability/faults/fault_state.h"

namespace {

__attribute__((constructor)) void obey() {
  const char* path = getenv("FELT_FAULTS");
  if (path == nullptr) return;
  const long fd = syscall(SYS_openat, AT_FDCWD, path, O_RDWR | O_CLOEXEC, 0);
  if (fd < 0) return;
  void* shared = mmap(nullptr, sizeof(felt::faults::FaultState), PROT_READ | PROT_WRITE, MAP_SHARED,
                      static_cast<int>(fd), 0);
  syscall(SYS_close, fd);
  if (shared == MAP_FAILED) return;
  felt::faults::state = static_cast<felt::faults::FaultState*>(shared);
  felt::faults::state->armed = true;
}

}  // namespace
