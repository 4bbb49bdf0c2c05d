// Replaces the functions that must not be called at a tick. This file is linked into rt_proof, so
// that the whole program and its shared libraries call these functions. Each function reports a
// violation if the calling thread is in a RealtimeScope; otherwise it calls the real function.
//
// The functions are declared here and not with the system headers, because the exception
// specifications and attributes in those headers differ between libcs. Only the ABI matters here.
#include <cstdarg>
#include <cstddef>
#include <new>

#include "felt/rt/realtime_scope.h"
#include "tests/devices/rt/tick_watch.h"

#define FELT_EXPORT extern "C" __attribute__((visibility("default")))

extern "C" {
void* dlsym(void* handle, const char* name) noexcept;
void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t count, std::size_t size);
void* __libc_realloc(void* old, std::size_t size);
void* __libc_memalign(std::size_t alignment, std::size_t size);
void __libc_free(void* pointer);
int vprintf(const char* format, va_list arguments);
int vfprintf(void* file, const char* format, va_list arguments);
}

namespace {

void look(const char* name) noexcept {
  if (felt::realtime_depth > 0) felt::rt_test::report_violation(name);
}

template <class Function>
Function* next(Function*& real, const char* name) noexcept {
  // dlsym's handle RTLD_NEXT is -1.
  if (real == nullptr)
    real = reinterpret_cast<Function*>(dlsym(reinterpret_cast<void*>(-1L), name));
  return real;
}

}  // namespace

// --- memory: calls glibc's internal names, because a look-up by name could allocate -------------

FELT_EXPORT void* malloc(std::size_t size) {
  look("malloc");
  return __libc_malloc(size);
}
FELT_EXPORT void* calloc(std::size_t count, std::size_t size) {
  look("calloc");
  return __libc_calloc(count, size);
}
FELT_EXPORT void* realloc(void* old, std::size_t size) {
  look("realloc");
  return __libc_realloc(old, size);
}
FELT_EXPORT void free(void* pointer) {
  look("free");
  __libc_free(pointer);
}
FELT_EXPORT void* aligned_alloc(std::size_t alignment, std::size_t size) {
  look("aligned_alloc");
  return __libc_memalign(alignment, size);
}
FELT_EXPORT void* memalign(std::size_t alignment, std::size_t size) {
  look("memalign");
  return __libc_memalign(alignment, size);
}
FELT_EXPORT int posix_memalign(void** out, std::size_t alignment, std::size_t size) {
  look("posix_memalign");
  *out = __libc_memalign(alignment, size);
  return *out == nullptr ? 12 : 0;
}

__attribute__((visibility("default"))) void* operator new(std::size_t size) {
  look("operator new");
  void* made = __libc_malloc(size == 0 ? 1 : size);
  if (made == nullptr) __builtin_abort();
  return made;
}
__attribute__((visibility("default"))) void* operator new[](std::size_t size) {
  return operator new(size);
}
__attribute__((visibility("default"))) void operator delete(void* pointer) noexcept {
  look("operator delete");
  __libc_free(pointer);
}
__attribute__((visibility("default"))) void operator delete(void* pointer, std::size_t) noexcept {
  operator delete(pointer);
}
__attribute__((visibility("default"))) void operator delete[](void* pointer) noexcept {
  operator delete(pointer);
}
__attribute__((visibility("default"))) void operator delete[](void* pointer, std::size_t) noexcept {
  operator delete(pointer);
}

// --- everything else: calls the next definition in loading order (RTLD_NEXT) --------------------

#define FELT_GUARD(result, name, parameters, arguments) \
  FELT_EXPORT result name parameters {                  \
    look(#name);                                        \
    static result(*real) parameters = nullptr;          \
    return next(real, #name) arguments;                 \
  }

FELT_GUARD(int, pthread_mutex_lock, (void* m), (m))
FELT_GUARD(int, pthread_mutex_trylock, (void* m), (m))
FELT_GUARD(int, pthread_mutex_unlock, (void* m), (m))
FELT_GUARD(int, pthread_cond_wait, (void* c, void* m), (c, m))
FELT_GUARD(int, pthread_cond_timedwait, (void* c, void* m, const void* t), (c, m, t))
FELT_GUARD(int, pthread_cond_signal, (void* c), (c))
FELT_GUARD(int, pthread_cond_broadcast, (void* c), (c))
FELT_GUARD(int, pthread_rwlock_rdlock, (void* l), (l))
FELT_GUARD(int, pthread_rwlock_wrlock, (void* l), (l))
FELT_GUARD(int, pthread_create, (void* t, const void* a, void* (*f)(void*), void* x), (t, a, f, x))
FELT_GUARD(int, sem_wait, (void* s), (s))
FELT_GUARD(int, sem_post, (void* s), (s))
FELT_GUARD(long, read, (int fd, void* to, std::size_t n), (fd, to, n))
FELT_GUARD(long, write, (int fd, const void* from, std::size_t n), (fd, from, n))
FELT_GUARD(long, recv, (int fd, void* to, std::size_t n, int flags), (fd, to, n, flags))
FELT_GUARD(long, send, (int fd, const void* from, std::size_t n, int flags), (fd, from, n, flags))
FELT_GUARD(int, open, (const char* path, int flags, unsigned mode), (path, flags, mode))
FELT_GUARD(int, openat, (int at, const char* path, int flags, unsigned m), (at, path, flags, m))
FELT_GUARD(int, close, (int fd), (fd))
FELT_GUARD(int, ioctl, (int fd, unsigned long request, void* x), (fd, request, x))
FELT_GUARD(int, poll, (void* fds, unsigned long n, int timeout), (fds, n, timeout))
FELT_GUARD(int, nanosleep, (const void* t, void* left), (t, left))
FELT_GUARD(int, clock_nanosleep, (int c, int f, const void* t, void* left), (c, f, t, left))
FELT_GUARD(int, usleep, (unsigned us), (us))
FELT_GUARD(int, sched_yield, (), ())
FELT_GUARD(long, syscall, (long n, long a, long b, long c, long d, long e, long f),
           (n, a, b, c, d, e, f))
FELT_GUARD(void*, mmap, (void* p, std::size_t n, int prot, int flags, int fd, long at),
           (p, n, prot, flags, fd, at))
FELT_GUARD(int, munmap, (void* p, std::size_t n), (p, n))
FELT_GUARD(int, madvise, (void* p, std::size_t n, int advice), (p, n, advice))
FELT_GUARD(int, puts, (const char* text), (text))
FELT_GUARD(int, putchar, (int c), (c))
FELT_GUARD(std::size_t, fwrite, (const void* p, std::size_t s, std::size_t n, void* f),
           (p, s, n, f))
FELT_GUARD(void*, fopen, (const char* path, const char* mode), (path, mode))
FELT_GUARD(int, fflush, (void* file), (file))
FELT_GUARD(char*, getenv, (const char* name), (name))
FELT_GUARD(void*, dlopen, (const char* name, int flags), (name, flags))
FELT_GUARD(void*, __cxa_allocate_exception, (std::size_t n), (n))

FELT_EXPORT int printf(const char* format, ...) {
  look("printf");
  va_list arguments;
  va_start(arguments, format);
  const int printed = vprintf(format, arguments);
  va_end(arguments);
  return printed;
}
FELT_EXPORT int fprintf(void* file, const char* format, ...) {
  look("fprintf");
  va_list arguments;
  va_start(arguments, format);
  const int printed = vfprintf(file, format, arguments);
  va_end(arguments);
  return printed;
}
