#include "felt/autosave/folder_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <utility>

namespace felt {
namespace {

/// Returns true if the path still names this file, that is, if the folder has not been removed
/// meanwhile.
bool is_at(int fd, const std::string& path) {
  struct stat here {};
  struct stat there {};
  return ::fstat(fd, &here) == 0 && ::stat(path.c_str(), &there) == 0 &&
         here.st_ino == there.st_ino && here.st_dev == there.st_dev;
}

tl::unexpected<Error> lock_error(const std::string& folder, const char* doing) {
  const int reason = errno;
  return fail(reason == ENOENT ? ErrorCode::kNotFound : ErrorCode::kIo,
              folder + ": " + doing + ": " + std::strerror(reason));
}

std::string folder_of(const char* variable, const char* below_home) {
  const char* value = std::getenv(variable);
  if (value && value[0] == '/') return value;
  if (!below_home) return {};
  const char* home = std::getenv("HOME");
  return home && home[0] == '/' ? std::string(home) + below_home : std::string();
}

}  // namespace

Result<FolderLock> FolderLock::take(const std::string& folder) {
  const std::string path = folder + "/lock";
  FolderLock lock;
  lock.fd_ = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0600);
  if (lock.fd_ < 0) return lock_error(folder, "cannot lock");
  const bool is_locked = ::flock(lock.fd_, LOCK_EX | LOCK_NB) == 0;
  if (!is_locked && errno != EWOULDBLOCK) return lock_error(folder, "cannot lock");
  if (!is_locked || !is_at(lock.fd_, path)) {
    return fail(ErrorCode::kUnsupported, folder + ": in use by another program");
  }
  return lock;
}

FolderLock::FolderLock(FolderLock&& other) noexcept : fd_(std::exchange(other.fd_, -1)) {}

FolderLock& FolderLock::operator=(FolderLock&& other) noexcept {
  std::swap(fd_, other.fd_);
  return *this;
}

FolderLock::~FolderLock() {
  if (fd_ >= 0) ::close(fd_);
}

Result<void> make_private_folder(const std::string& path) {
  for (std::size_t at = 1; (at = path.find('/', at)) != std::string::npos; ++at) {
    ::mkdir(path.substr(0, at).c_str(), 0700);  // an error for the last folder is reported below
  }
  if (::mkdir(path.c_str(), 0700) != 0 && errno != EEXIST) {
    return lock_error(path, "cannot create");
  }
  struct stat info {};
  if (::lstat(path.c_str(), &info) != 0) return lock_error(path, "cannot access");
  if (S_ISLNK(info.st_mode) && info.st_uid == ::getuid() && ::stat(path.c_str(), &info) != 0) {
    return lock_error(path, "cannot access");
  }
  if (!S_ISDIR(info.st_mode)) return fail(ErrorCode::kIo, path + ": not a folder");
  if (info.st_uid != ::geteuid()) return fail(ErrorCode::kIo, path + ": belongs to another user");
  if ((info.st_mode & 077) != 0 && ::chmod(path.c_str(), 0700) != 0) {
    return lock_error(path, "other users have access to it, and this cannot be changed");
  }
  return {};
}

std::vector<std::string> autosave_roots() {
  std::vector<std::string> roots;
  const auto add = [&roots](const std::string& folder, const std::string& name) {
    if (!folder.empty()) roots.push_back(folder + name);
  };
  add(folder_of("XDG_STATE_HOME", "/.local/state"), "/feltline/working");
  add(folder_of("XDG_CACHE_HOME", "/.cache"), "/feltline/working");
  add(folder_of("XDG_RUNTIME_DIR", nullptr), "/feltline/working");
  const std::string temporary = folder_of("TMPDIR", nullptr);
  add(temporary.empty() ? "/tmp" : temporary, "/feltline-" + std::to_string(::getuid()));
  return roots;
}

}  // namespace felt
