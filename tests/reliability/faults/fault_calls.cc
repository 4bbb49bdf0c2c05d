// Replaces the C library functions that read or change files. Counts the calls on files below
// FaultState::folder and lets the chosen call fail. It is linked into the driver or preloaded into
// a program (fault_preload.cc). In both cases the calls of shared libraries, such as SQLite, pass
// through it too.
//
// The replacements make system calls directly. They need no look-up of the real functions, and no
// library between them and the kernel can repeat or hide a call. Writes to memory-mapped files
// (SQLite's -shm) are not intercepted, but no later process relies on these files.
#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/uio.h>
#include <unistd.h>

#include "tests/reliability/faults/fault_state.h"

#define FELT_EXPORT extern "C" __attribute__((visibility("default")))

namespace {

using felt::faults::Call;
using felt::faults::Mode;
using felt::faults::state;

constexpr int kDescriptors = 4096;
// For each descriptor: true if its file lies in the watched folder, and the path of that file.
bool watched[kDescriptors];
char names[kDescriptors][256];

/// Returns the absolute path if it lies in the watched folder, otherwise null. The result is valid
/// until the next call on this thread.
const char* inside(int folder_fd, const char* path) noexcept {
  thread_local char whole[1024];
  if (state == nullptr || state->memory || path == nullptr) return nullptr;
  if (path[0] == '/') {
    snprintf(whole, sizeof whole, "%s", path);
  } else if (folder_fd == AT_FDCWD) {
    char current[512];
    if (syscall(SYS_getcwd, current, sizeof current) <= 0) return nullptr;
    snprintf(whole, sizeof whole, "%s/%s", current, path);
  } else {
    char link[64];
    char target[512] = {};
    snprintf(link, sizeof link, "/proc/self/fd/%d", folder_fd);
    if (syscall(SYS_readlinkat, AT_FDCWD, link, target, sizeof target - 1) <= 0) return nullptr;
    snprintf(whole, sizeof whole, "%s/%s", target, path);
  }
  const std::size_t size = strlen(state->folder);
  const bool below =
      strncmp(whole, state->folder, size) == 0 && (whole[size] == '/' || whole[size] == '\0');
  return below ? whole : nullptr;
}

bool is_watched(int fd) noexcept {
  return state != nullptr && !state->memory && fd >= 0 && fd < kDescriptors && watched[fd];
}

bool fails_on(int fd, Call call, const char* name) noexcept {
  return is_watched(fd) && felt::faults::fails(call, name, names[fd]);
}

/// Reads or writes half of the bytes. Then kills the process if the mode is kHalfKill; otherwise
/// returns the number of bytes transferred.
ssize_t half_of(long (*call)(int, const void*, size_t, off64_t), int fd, const void* bytes,
                size_t size, off64_t offset) noexcept {
  const ssize_t done = call(fd, bytes, size > 1 ? size / 2 : size, offset);
  if (state->mode == Mode::kHalfKill) kill(getpid(), SIGKILL);
  return done;
}

bool is_half() noexcept {
  return state->mode == Mode::kShort || state->mode == Mode::kHalfKill;
}

long plain_write(int fd, const void* bytes, size_t size, off64_t) {
  return syscall(SYS_write, fd, bytes, size);
}
long placed_write(int fd, const void* bytes, size_t size, off64_t offset) {
  return syscall(SYS_pwrite64, fd, bytes, size, offset);
}
long plain_read(int fd, const void* bytes, size_t size, off64_t) {
  return syscall(SYS_read, fd, bytes, size);
}
long placed_read(int fd, const void* bytes, size_t size, off64_t offset) {
  return syscall(SYS_pread64, fd, bytes, size, offset);
}

ssize_t transfer(long (*call)(int, const void*, size_t, off64_t), Call kind, const char* name,
                 int fd, const void* bytes, size_t size, off64_t offset) noexcept {
  if (!fails_on(fd, kind, name)) return call(fd, bytes, size, offset);
  return is_half() ? half_of(call, fd, bytes, size, offset) : -1;
}

int open_file(int folder_fd, const char* path, int flags, mode_t mode) noexcept {
  const char* place = inside(folder_fd, path);
  const bool unnamed = (flags & O_TMPFILE) == O_TMPFILE;
  const bool creates = unnamed || (flags & O_CREAT) != 0;
  if (place != nullptr) {
    if (felt::faults::fails(creates ? Call::kCreate : Call::kOpen, "open", place)) return -1;
    if (unnamed && state->armed && state->no_unnamed) return errno = EOPNOTSUPP, -1;
    if (state->armed && state->read_only &&
        (unnamed || (creates && syscall(SYS_faccessat, AT_FDCWD, place, F_OK) != 0))) {
      return errno = EACCES, -1;
    }
  }
  const long fd = syscall(SYS_openat, folder_fd, path, flags, mode);
  if (fd >= 0 && fd < kDescriptors) {
    watched[fd] = place != nullptr;
    if (place != nullptr) snprintf(names[fd], sizeof names[fd], "%s", place);
  }
  return static_cast<int>(fd);
}

/// Counts a call that changes an entry of a folder, such as rename or unlink. Returns true and sets
/// errno if the call must fail.
bool name_fails(Call call, const char* name, int folder_fd, const char* path) noexcept {
  const char* place = inside(folder_fd, path);
  if (place == nullptr) return false;
  if (felt::faults::fails(call, name, place)) return true;
  if (!state->armed || !state->read_only) return false;
  errno = EACCES;
  return true;
}

mode_t mode_of(int flags, va_list arguments) noexcept {
  const bool creates = (flags & O_CREAT) != 0 || (flags & O_TMPFILE) == O_TMPFILE;
  return creates ? static_cast<mode_t>(va_arg(arguments, unsigned)) : 0;
}

}  // namespace

// --- open, close ---------------------------------------------------------------------------------

#define FELT_OPEN(NAME)                                    \
  FELT_EXPORT int NAME(const char* path, int flags, ...) { \
    va_list arguments;                                     \
    va_start(arguments, flags);                            \
    const mode_t mode = mode_of(flags, arguments);         \
    va_end(arguments);                                     \
    return open_file(AT_FDCWD, path, flags, mode);         \
  }
#define FELT_OPENAT(NAME)                                              \
  FELT_EXPORT int NAME(int folder, const char* path, int flags, ...) { \
    va_list arguments;                                                 \
    va_start(arguments, flags);                                        \
    const mode_t mode = mode_of(flags, arguments);                     \
    va_end(arguments);                                                 \
    return open_file(folder, path, flags, mode);                       \
  }
FELT_OPEN(open)
FELT_OPEN(open64)
FELT_OPENAT(openat)
FELT_OPENAT(openat64)

FELT_EXPORT int creat(const char* path, mode_t mode) {
  return open_file(AT_FDCWD, path, O_CREAT | O_WRONLY | O_TRUNC, mode);
}
FELT_EXPORT int creat64(const char* path, mode_t mode) {
  return creat(path, mode);
}

/// Closes the descriptor even if the call fails, as Linux does. A failed close only reports that an
/// earlier write was lost.
FELT_EXPORT int close(int fd) {
  const bool failed = fails_on(fd, Call::kClose, "close");
  const int reason = errno;
  if (fd >= 0 && fd < kDescriptors) watched[fd] = false;
  const long result = syscall(SYS_close, fd);
  if (failed) errno = reason;
  return failed ? -1 : static_cast<int>(result);
}

// --- bytes ---------------------------------------------------------------------------------------

FELT_EXPORT ssize_t write(int fd, const void* bytes, size_t size) {
  return transfer(plain_write, Call::kWrite, "write", fd, bytes, size, 0);
}
FELT_EXPORT ssize_t pwrite(int fd, const void* bytes, size_t size, off_t offset) {
  return transfer(placed_write, Call::kWrite, "pwrite", fd, bytes, size, offset);
}
FELT_EXPORT ssize_t pwrite64(int fd, const void* bytes, size_t size, off64_t offset) {
  return transfer(placed_write, Call::kWrite, "pwrite", fd, bytes, size, offset);
}
FELT_EXPORT ssize_t read(int fd, void* bytes, size_t size) {
  return transfer(plain_read, Call::kRead, "read", fd, bytes, size, 0);
}
FELT_EXPORT ssize_t pread(int fd, void* bytes, size_t size, off_t offset) {
  return transfer(placed_read, Call::kRead, "pread", fd, bytes, size, offset);
}
FELT_EXPORT ssize_t pread64(int fd, void* bytes, size_t size, off64_t offset) {
  return transfer(placed_read, Call::kRead, "pread", fd, bytes, size, offset);
}

/// A half write transfers half of the first piece only.
FELT_EXPORT ssize_t writev(int fd, const struct iovec* pieces, int count) {
  if (fails_on(fd, Call::kWrite, "writev")) {
    return is_half() ? half_of(plain_write, fd, pieces->iov_base, pieces->iov_len, 0) : -1;
  }
  return syscall(SYS_writev, fd, pieces, count);
}
FELT_EXPORT ssize_t pwritev(int fd, const struct iovec* pieces, int count, off_t offset) {
  if (fails_on(fd, Call::kWrite, "pwritev")) {
    return is_half() ? half_of(placed_write, fd, pieces->iov_base, pieces->iov_len, offset) : -1;
  }
  return syscall(SYS_pwritev, fd, pieces, count, offset, 0);
}
FELT_EXPORT ssize_t copy_file_range(int in, off64_t* in_at, int out, off64_t* out_at, size_t size,
                                    unsigned flags) {
  if (fails_on(out, Call::kWrite, "copy_file_range") && !is_half()) return -1;
  return syscall(SYS_copy_file_range, in, in_at, out, out_at, size, flags);
}
FELT_EXPORT ssize_t sendfile(int out, int in, off_t* in_at, size_t size) {
  if (fails_on(out, Call::kWrite, "sendfile") && !is_half()) return -1;
  return syscall(SYS_sendfile, out, in, in_at, size);
}
FELT_EXPORT ssize_t sendfile64(int out, int in, off64_t* in_at, size_t size) {
  return sendfile(out, in, in_at, size);
}

// --- to the disk ---------------------------------------------------------------------------------

FELT_EXPORT int fsync(int fd) {
  if (fails_on(fd, Call::kSync, "fsync")) return -1;
  return static_cast<int>(syscall(SYS_fsync, fd));
}
FELT_EXPORT int fdatasync(int fd) {
  if (fails_on(fd, Call::kSync, "fdatasync")) return -1;
  return static_cast<int>(syscall(SYS_fdatasync, fd));
}
FELT_EXPORT int syncfs(int fd) noexcept {
  if (fails_on(fd, Call::kSync, "syncfs")) return -1;
  return static_cast<int>(syscall(SYS_syncfs, fd));
}

// --- length --------------------------------------------------------------------------------------

FELT_EXPORT int ftruncate(int fd, off_t size) noexcept {
  if (fails_on(fd, Call::kTruncate, "ftruncate")) return -1;
  return static_cast<int>(syscall(SYS_ftruncate, fd, size));
}
FELT_EXPORT int ftruncate64(int fd, off64_t size) noexcept {
  return ftruncate(fd, size);
}
FELT_EXPORT int fallocate(int fd, int mode, off_t offset, off_t size) {
  if (fails_on(fd, Call::kAllocate, "fallocate")) return -1;
  return static_cast<int>(syscall(SYS_fallocate, fd, mode, offset, size));
}
FELT_EXPORT int fallocate64(int fd, int mode, off64_t offset, off64_t size) {
  return fallocate(fd, mode, offset, size);
}
/// Returns the error number instead of setting errno, as POSIX specifies.
FELT_EXPORT int posix_fallocate(int fd, off_t offset, off_t size) {
  return fallocate(fd, 0, offset, size) == 0 ? 0 : errno;
}
FELT_EXPORT int posix_fallocate64(int fd, off64_t offset, off64_t size) {
  return posix_fallocate(fd, offset, size);
}

// --- names ---------------------------------------------------------------------------------------

FELT_EXPORT int renameat2(int from_folder, const char* from, int to_folder, const char* to,
                          unsigned flags) noexcept {
  if (name_fails(Call::kRename, "rename", to_folder, to)) return -1;
  return static_cast<int>(syscall(SYS_renameat2, from_folder, from, to_folder, to, flags));
}
FELT_EXPORT int renameat(int from_folder, const char* from, int to_folder,
                         const char* to) noexcept {
  return renameat2(from_folder, from, to_folder, to, 0);
}
FELT_EXPORT int rename(const char* from, const char* to) noexcept {
  return renameat2(AT_FDCWD, from, AT_FDCWD, to, 0);
}
FELT_EXPORT int linkat(int from_folder, const char* from, int to_folder, const char* to,
                       int flags) noexcept {
  if (name_fails(Call::kLink, "link", to_folder, to)) return -1;
  return static_cast<int>(syscall(SYS_linkat, from_folder, from, to_folder, to, flags));
}
FELT_EXPORT int link(const char* from, const char* to) noexcept {
  return linkat(AT_FDCWD, from, AT_FDCWD, to, 0);
}
FELT_EXPORT int symlink(const char* target, const char* path) noexcept {
  if (name_fails(Call::kLink, "symlink", AT_FDCWD, path)) return -1;
  return static_cast<int>(syscall(SYS_symlinkat, target, AT_FDCWD, path));
}
FELT_EXPORT int unlinkat(int folder, const char* path, int flags) noexcept {
  if (name_fails(Call::kUnlink, "unlink", folder, path)) return -1;
  return static_cast<int>(syscall(SYS_unlinkat, folder, path, flags));
}
FELT_EXPORT int unlink(const char* path) noexcept {
  return unlinkat(AT_FDCWD, path, 0);
}
FELT_EXPORT int rmdir(const char* path) noexcept {
  return unlinkat(AT_FDCWD, path, AT_REMOVEDIR);
}
FELT_EXPORT int remove(const char* path) noexcept {
  const int result = unlink(path);
  return result != 0 && (errno == EISDIR || errno == EPERM) ? rmdir(path) : result;
}
FELT_EXPORT int mkdirat(int folder, const char* path, mode_t mode) noexcept {
  if (name_fails(Call::kFolder, "mkdir", folder, path)) return -1;
  return static_cast<int>(syscall(SYS_mkdirat, folder, path, mode));
}
FELT_EXPORT int mkdir(const char* path, mode_t mode) noexcept {
  return mkdirat(AT_FDCWD, path, mode);
}

// --- queries -------------------------------------------------------------------------------------

namespace {

bool look_fails(int folder, const char* path, const char* name) noexcept {
  const char* place = inside(folder, path);
  return place != nullptr && felt::faults::fails(Call::kLook, name, place);
}

int look(int folder, const char* path, void* info, int flags) noexcept {
  if (look_fails(folder, path, "stat")) return -1;
  return static_cast<int>(syscall(SYS_newfstatat, folder, path, info, flags));
}

}  // namespace

FELT_EXPORT int stat(const char* path, struct stat* info) noexcept {
  return look(AT_FDCWD, path, info, 0);
}
FELT_EXPORT int stat64(const char* path, struct stat64* info) noexcept {
  return look(AT_FDCWD, path, info, 0);
}
FELT_EXPORT int lstat(const char* path, struct stat* info) noexcept {
  return look(AT_FDCWD, path, info, AT_SYMLINK_NOFOLLOW);
}
FELT_EXPORT int lstat64(const char* path, struct stat64* info) noexcept {
  return look(AT_FDCWD, path, info, AT_SYMLINK_NOFOLLOW);
}
FELT_EXPORT int fstatat(int folder, const char* path, struct stat* info, int flags) noexcept {
  return look(folder, path, info, flags);
}
FELT_EXPORT int fstatat64(int folder, const char* path, struct stat64* info, int flags) noexcept {
  return look(folder, path, info, flags);
}
FELT_EXPORT int access(const char* path, int how) noexcept {
  if (look_fails(AT_FDCWD, path, "access")) return -1;
  return static_cast<int>(syscall(SYS_faccessat, AT_FDCWD, path, how));
}
/// Opens the descriptor itself, because the C library's internal open and close bypass this file.
FELT_EXPORT DIR* opendir(const char* path) {
  const int fd = open_file(AT_FDCWD, path, O_RDONLY | O_DIRECTORY | O_CLOEXEC, 0);
  if (fd < 0) return nullptr;
  if (fd < kDescriptors) watched[fd] = false;  // closedir() closes it without calling close() here
  return fdopendir(fd);
}

// --- attributes ----------------------------------------------------------------------------------

FELT_EXPORT int fchmod(int fd, mode_t mode) noexcept {
  if (fails_on(fd, Call::kAttribute, "fchmod")) return -1;
  return static_cast<int>(syscall(SYS_fchmod, fd, mode));
}
FELT_EXPORT int fchown(int fd, uid_t owner, gid_t group) noexcept {
  if (fails_on(fd, Call::kAttribute, "fchown")) return -1;
  return static_cast<int>(syscall(SYS_fchown, fd, owner, group));
}
FELT_EXPORT int fsetxattr(int fd, const char* name, const void* value, size_t size,
                          int flags) noexcept {
  if (fails_on(fd, Call::kAttribute, "fsetxattr")) return -1;
  return static_cast<int>(syscall(SYS_fsetxattr, fd, name, value, size, flags));
}
