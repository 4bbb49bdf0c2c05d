#include "felt/autosave/folder_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <utility>

namespace felt {
namespace {

std::string first_line(const std::string& path) {
  std::ifstream file(path);
  std::string line;
  std::getline(file, line);
  return line;
}

/// When the process began, in ticks since the boot: the 22nd word of its `stat`; the second is in
/// brackets and may hold anything. "" where it does not live, or nobody says.
std::string start_of(const std::string& pid) {
  const std::string stat = first_line("/proc/" + pid + "/stat");
  std::size_t at = stat.rfind(')');
  for (int word = 2; word < 22 && at != std::string::npos; ++word) at = stat.find(' ', at + 1);
  return at == std::string::npos ? "" : stat.substr(at + 1, stat.find(' ', at + 1) - at - 1);
}

/// "PID START BOOT"
std::string who_we_are() {
  const std::string pid = std::to_string(::getpid());
  return pid + ' ' + start_of(pid) + ' ' + first_line("/proc/sys/kernel/random/boot_id");
}

/// Whether the process that wrote this into a lock lives. For file systems that know no locks.
bool lives(const std::string& who) {
  const std::size_t first = who.find(' '), second = who.find(' ', first + 1);
  if (second == std::string::npos) return false;
  const std::string pid = who.substr(0, first);
  if (who.substr(second + 1) != first_line("/proc/sys/kernel/random/boot_id")) return false;
  return !pid.empty() && start_of(pid) == who.substr(first + 1, second - first - 1);
}

std::string read_all(int fd) {
  std::array<char, 256> bytes{};
  const ssize_t n = ::pread(fd, bytes.data(), bytes.size(), 0);
  return n > 0 ? std::string(bytes.data(), static_cast<std::size_t>(n)) : std::string();
}

/// The name still leads to this file: nobody removed the folder meanwhile.
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
  if (lock.fd_ < 0) return lock_error(folder, "cannot be locked");
  const auto in_use = [&] {
    return fail(ErrorCode::kUnsupported, folder + ": is in use by another program");
  };
  if (::flock(lock.fd_, LOCK_EX | LOCK_NB) != 0) {
    if (errno == EWOULDBLOCK) return in_use();
    const std::string who = read_all(lock.fd_);
    if (lives(who)) return in_use();  // this process, too
  }
  if (!is_at(lock.fd_, path)) return in_use();
  const std::string who = who_we_are();
  if (::ftruncate(lock.fd_, 0) != 0 ||
      ::pwrite(lock.fd_, who.data(), who.size(), 0) != static_cast<ssize_t>(who.size())) {
    return lock_error(folder, "cannot be locked");
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
    ::mkdir(path.substr(0, at).c_str(), 0700);  // what is missing; the last one says the rest
  }
  if (::mkdir(path.c_str(), 0700) != 0 && errno != EEXIST) {
    return lock_error(path, "cannot be made");
  }
  struct stat info {};
  if (::lstat(path.c_str(), &info) != 0) return lock_error(path, "cannot be looked at");
  if (S_ISLNK(info.st_mode) && info.st_uid == ::getuid() && ::stat(path.c_str(), &info) != 0) {
    return lock_error(path, "cannot be looked at");
  }
  if (!S_ISDIR(info.st_mode)) return fail(ErrorCode::kIo, path + ": is no folder");
  if (info.st_uid != ::geteuid()) return fail(ErrorCode::kIo, path + ": belongs to somebody else");
  if ((info.st_mode & 077) != 0 && ::chmod(path.c_str(), 0700) != 0) {
    return lock_error(path, "is open to others, and stays so");
  }
  return {};
}

std::vector<std::string> working_roots() {
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
