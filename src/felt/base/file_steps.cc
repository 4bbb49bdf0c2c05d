#include "felt/base/file_steps.h"

#include <dirent.h>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/xattr.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <vector>

namespace felt::file_steps {
namespace {

constexpr int kNameAttempts = 100;
constexpr int kMaxLinks = 40;  // the system's own limit
constexpr std::size_t kChunkBytes = std::size_t{1} << 16;
/// Only this many bytes of the name go into a hidden name, so that it is never too long.
constexpr std::size_t kNamePart = 200;
constexpr std::string_view kNewEnding = ".tmp", kOldEnding = ".old";

std::string name_of(const std::string& path) {
  return path.substr(path.rfind('/') + 1);
}

std::string prefix_of(const std::string& target) {
  return "." + name_of(target).substr(0, kNamePart) + ".";
}

/// Returns the path by which the system shows an open file, even one without a name.
std::string descriptor_path(int fd) {
  return "/proc/self/fd/" + std::to_string(fd);
}

/// Returns true for "1234-5".
bool is_mark(std::string_view text) noexcept {
  return !text.empty() && std::all_of(text.begin(), text.end(),
                                      [](char c) { return (c >= '0' && c <= '9') || c == '-'; });
}

/// Returns true for prefix + mark + ending; the prefix is ".NAME.".
bool is_name_beside(std::string_view name, std::string_view prefix, std::string_view ending) {
  if (!name.starts_with(prefix) || !name.ends_with(ending)) return false;
  if (name.size() < prefix.size() + ending.size()) return false;
  name.remove_prefix(prefix.size());
  return is_mark(name.substr(0, name.size() - ending.size()));
}

void copy_xattr(int from, int to, const char* name) noexcept {
  const ssize_t size = ::fgetxattr(from, name, nullptr, 0);
  if (size < 0) return;
  std::vector<char> value(static_cast<std::size_t>(size));
  const ssize_t got = ::fgetxattr(from, name, value.data(), value.size());
  if (got < 0) return;
  static_cast<void>(::fsetxattr(to, name, value.data(), static_cast<std::size_t>(got), 0));
}

/// Reads `size` bytes, or fewer at the end of the file. Returns -1 with errno on an error.
ssize_t read_some(int fd, char* into, std::size_t size) noexcept {
  std::size_t have = 0;
  while (have < size) {
    const ssize_t n = ::read(fd, into + have, size - have);
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) return -1;
    if (n == 0) break;
    have += static_cast<std::size_t>(n);
  }
  return static_cast<ssize_t>(have);
}

bool is_same(int fd, std::string_view bytes) noexcept {
  std::array<char, kChunkBytes> chunk{};
  for (;;) {
    const ssize_t n = read_some(fd, chunk.data(), chunk.size());
    if (n < 0) return false;
    const std::string_view read(chunk.data(), static_cast<std::size_t>(n));
    if (bytes.substr(0, read.size()) != read) break;
    bytes.remove_prefix(read.size());
    if (read.size() < chunk.size()) {
      errno = 0;
      return bytes.empty();
    }
  }
  errno = 0;
  return false;
}

bool copy_bytes(int from, int to) noexcept {
  std::array<char, kChunkBytes> chunk{};
  for (;;) {
    const ssize_t n = read_some(from, chunk.data(), chunk.size());
    if (n < 0) return false;
    if (n == 0) return ::fsync(to) == 0;
    if (!write_all(to, {chunk.data(), static_cast<std::size_t>(n)})) return false;
  }
}

std::string copy_beside(const std::string& path) {
  const int from = open_file(path, O_RDONLY);
  if (from < 0) return {};
  std::string name = name_beside(path, kOldEnding.data());
  const int to = open_file(name, O_WRONLY | O_CREAT | O_EXCL, 0600);
  const bool done = to >= 0 && copy_bytes(from, to);
  const int reason = errno;
  if (done) copy_attributes(from, to);
  ::close(from);
  if (to >= 0) ::close(to);
  if (done) return name;
  if (to >= 0) ::unlink(name.c_str());
  errno = reason;
  return {};
}

/// Returns true if no process holds a lock on the file. Also returns false if this cannot be
/// determined.
bool is_abandoned(const std::string& path) noexcept {
  const int fd = open_file(path, O_RDONLY | O_NOFOLLOW | O_NONBLOCK);
  if (fd < 0) return false;
  struct stat info {};
  const bool is_free =
      ::fstat(fd, &info) == 0 && S_ISREG(info.st_mode) && ::flock(fd, LOCK_EX | LOCK_NB) == 0;
  ::close(fd);
  return is_free;
}

}  // namespace

int open_file(const std::string& path, int flags, mode_t permissions) noexcept {
  int fd = -1;
  do {
    fd = ::open(path.c_str(), flags | O_CLOEXEC, permissions);
  } while (fd < 0 && errno == EINTR);
  return fd;
}

std::string resolved(const std::string& path) {
  std::string at = path;
  for (int i = 0; i < kMaxLinks; ++i) {
    const std::unique_ptr<char, decltype(&std::free)> real(::realpath(at.c_str(), nullptr),
                                                           &std::free);
    if (real) return real.get();
    std::array<char, 4096> text{};
    const ssize_t size = ::readlink(at.c_str(), text.data(), text.size() - 1);
    if (size < 0) return at;
    // The link leads to a file that does not exist yet, which is the file to create.
    const std::string next(text.data(), static_cast<std::size_t>(size));
    at = next.starts_with('/') ? next : folder_of(at) + "/" + next;
  }
  return path;
}

std::string folder_of(const std::string& path) {
  const auto slash = path.rfind('/');
  if (slash == std::string::npos) return ".";
  return slash == 0 ? "/" : path.substr(0, slash);
}

std::string name_beside(const std::string& target, const char* ending) {
  static std::atomic<unsigned> counter{0};
  return folder_of(target) + "/" + prefix_of(target) + std::to_string(::getpid()) + "-" +
         std::to_string(counter.fetch_add(1)) + ending;
}

bool write_all(int fd, std::string_view bytes) noexcept {
  while (!bytes.empty()) {
    const ssize_t n = ::write(fd, bytes.data(), bytes.size());
    if (n < 0 && errno != EINTR) return false;
    if (n > 0) bytes.remove_prefix(static_cast<std::size_t>(n));
  }
  return true;
}

int open_unnamed(const std::string& folder, mode_t permissions) {
#ifdef O_TMPFILE
  const int fd = open_file(folder, O_TMPFILE | O_RDWR, permissions);
  if (fd < 0 || ::access(descriptor_path(fd).c_str(), F_OK) == 0) return fd;
  ::close(fd);
#else
  static_cast<void>(folder);
  static_cast<void>(permissions);
#endif
  return -1;
}

int open_named(const std::string& target, mode_t permissions, std::string& name) {
  for (int attempt = 0; attempt < kNameAttempts; ++attempt) {
    std::string candidate = name_beside(target, kNewEnding.data());
    const int fd = open_file(candidate, O_RDWR | O_CREAT | O_EXCL, permissions);
    if (fd >= 0) name = std::move(candidate);
    if (fd >= 0 || errno != EEXIST) return fd;
  }
  return -1;
}

std::string give_name(int fd, const std::string& target) {
  for (int attempt = 0; attempt < kNameAttempts; ++attempt) {
    std::string name = name_beside(target, kNewEnding.data());
    if (::linkat(AT_FDCWD, descriptor_path(fd).c_str(), AT_FDCWD, name.c_str(),
                 AT_SYMLINK_FOLLOW) == 0) {
      return name;
    }
    if (errno != EEXIST) break;
  }
  return {};
}

void copy_attributes(int from, int to) noexcept {
  struct stat info {
  }, present{};
  if (::fstat(from, &info) != 0 || ::fstat(to, &present) != 0) return;
  if (info.st_gid != present.st_gid) static_cast<void>(::fchown(to, uid_t(-1), info.st_gid) == 0);
  if (info.st_uid != present.st_uid) static_cast<void>(::fchown(to, info.st_uid, gid_t(-1)) == 0);
  static_cast<void>(::fchmod(to, info.st_mode & 01777));  // no set-uid: the content is new
  const ssize_t size = ::flistxattr(from, nullptr, 0);
  if (size <= 0) return;
  std::vector<char> names(static_cast<std::size_t>(size));
  const ssize_t got = ::flistxattr(from, names.data(), names.size());
  for (ssize_t at = 0; at < got;) {
    const char* name = names.data() + at;
    copy_xattr(from, to, name);
    at += static_cast<ssize_t>(std::strlen(name)) + 1;
  }
}

bool holds(const std::string& path, std::string_view bytes) noexcept {
  const int fd = open_file(path, O_RDONLY);
  if (fd < 0) return false;
  // Drops the clean pages from the page cache, so that the reads below come from the disk.
  static_cast<void>(::posix_fadvise(fd, 0, 0, POSIX_FADV_DONTNEED));
  const bool same = is_same(fd, bytes);
  const int reason = errno;
  ::close(fd);
  errno = reason;
  return same;
}

std::string keep_beside(const std::string& path) {
  for (int attempt = 0; attempt < kNameAttempts; ++attempt) {
    std::string name = name_beside(path, kOldEnding.data());
    if (::link(path.c_str(), name.c_str()) == 0) return name;
    if (errno != EEXIST) break;
  }
  return copy_beside(path);
}

bool sync_folder(const std::string& folder) noexcept {
  const int fd = open_file(folder, O_RDONLY | O_DIRECTORY);
  if (fd < 0) return errno == EACCES;  // the folder is writable but not readable
  const bool synced = ::fsync(fd) == 0 || errno == EINVAL;
  const int reason = errno;
  ::close(fd);
  errno = reason;
  return synced;
}

void remove_leftovers(const std::string& target, bool old_ones) {
  const std::string folder = folder_of(target), prefix = prefix_of(target);
  DIR* entries = ::opendir(folder.c_str());
  if (!entries) return;
  while (const dirent* entry = ::readdir(entries)) {
    if (!is_name_beside(entry->d_name, prefix, kNewEnding) &&
        !(old_ones && is_name_beside(entry->d_name, prefix, kOldEnding))) {
      continue;
    }
    const std::string path = folder + "/" + entry->d_name;
    if (is_abandoned(path)) ::unlink(path.c_str());
  }
  ::closedir(entries);
}

void hold_lock(int fd) noexcept {
  static_cast<void>(::flock(fd, LOCK_EX | LOCK_NB));
}

}  // namespace felt::file_steps
