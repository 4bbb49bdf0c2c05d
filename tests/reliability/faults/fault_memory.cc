// Replaces the allocation functions for the driver and its shared libraries. The real functions are
// called by glibc's internal names, because looking them up would allocate. They are declared by
// hand because headers differ in their exception specifications, while only the ABI matters here.
#include <cstddef>

#include "tests/reliability/faults/fault_state.h"

#define FELT_EXPORT extern "C" __attribute__((visibility("default")))

extern "C" {
void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t count, std::size_t size);
void* __libc_realloc(void* old, std::size_t size);
void* __libc_memalign(std::size_t alignment, std::size_t size);
}

using felt::faults::allocation_fails;

FELT_EXPORT void* malloc(std::size_t size) {
  return allocation_fails() ? nullptr : __libc_malloc(size);
}
FELT_EXPORT void* calloc(std::size_t count, std::size_t size) {
  return allocation_fails() ? nullptr : __libc_calloc(count, size);
}
FELT_EXPORT void* realloc(void* old, std::size_t size) {
  return allocation_fails() ? nullptr : __libc_realloc(old, size);
}
FELT_EXPORT void* aligned_alloc(std::size_t alignment, std::size_t size) {
  return allocation_fails() ? nullptr : __libc_memalign(alignment, size);
}
FELT_EXPORT void* memalign(std::size_t alignment, std::size_t size) {
  return allocation_fails() ? nullptr : __libc_memalign(alignment, size);
}
FELT_EXPORT int posix_memalign(void** out, std::size_t alignment, std::size_t size) {
  *out = allocation_fails() ? nullptr : __libc_memalign(alignment, size);
  return *out == nullptr ? 12 : 0;
}
