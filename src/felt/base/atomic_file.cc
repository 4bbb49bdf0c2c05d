#include "felt/base/atomic_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <utility>

namespace felt {
namespace {

constexpr std::size_t kBufferBytes = std::size_t{1} << 16;
constexpr int kNameAttempts = 100;

/// write(2) until all is out. False with errno on failure.
bool write_all(int fd, std::string_view bytes) noexcept {
  while (!bytes.empty()) {
    const ssize_t n = ::write(fd, bytes.data(), bytes.size());
    if (n < 0 && errno != EINTR) return false;
    if (n > 0) bytes.remove_prefix(static_cast<std::size_t>(n));
  }
  return true;
}

/// The file that a path means once links are followed; the path itself where nothing exists yet.
std::string resolved(const std::string& path) {
  const std::unique_ptr<char, decltype(&std::free)> real(::realpath(path.c_str(), nullptr),
                                                         &std::free);
  return real ? std::string(real.get()) : path;
}

std::string folder_of(const std::string& path) {
  const auto slash = path.rfind('/');
  if (slash == std::string::npos) return ".";
  return slash == 0 ? "/" : path.substr(0, slash);
}

std::string name_of(const std::string& path) {
  return path.substr(path.rfind('/') + 1);
}

/// A name that no other file of this or another process has at the moment.
std::string temporary_name(const std::string& target) {
  static std::atomic<unsigned> counter{0};
  return folder_of(target) + "/." + name_of(target) + "." + std::to_string(::getpid()) + "-" +
         std::to_string(counter.fetch_add(1)) + ".tmp";
}

/// The name under which the system shows an open file, also one without a name of its own.
std::string descriptor_path(int fd) {
  return "/proc/self/fd/" + std::to_string(fd);
}

/// A file in `folder` that has no name yet and vanishes with the process; -1 where the system has
/// no such files, or no way to name them later.
int open_unnamed(const std::string& folder) {
#ifdef O_TMPFILE
  // 0666 less the umask: the permissions that any new file gets.
  const int fd = ::open(folder.c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, 0666);
  if (fd < 0 || ::access(descriptor_path(fd).c_str(), F_OK) == 0) return fd;
  ::close(fd);
#else
  static_cast<void>(folder);
#endif
  return -1;
}

}  // namespace

Result<AtomicFile> AtomicFile::create(const std::string& path) {
  if (path.empty()) return fail(ErrorCode::kInvalidArgument, "a file to write needs a name");
  AtomicFile file;
  file.shown_name_ = path == "-" ? "stdout" : path;
  if (path != "-") file.target_ = resolved(path);
  struct stat info {};
  const bool exists = path != "-" && ::stat(file.target_.c_str(), &info) == 0;
  const bool replaceable = path != "-" && (!exists || S_ISREG(info.st_mode));
  if (exists && S_ISDIR(info.st_mode)) {
    errno = EISDIR;
    return file.error("cannot write");
  }
  if (auto ok = replaceable ? file.open_beside_target() : file.open_spool(); !ok) {
    return tl::unexpected<Error>(std::move(ok.error()));
  }
  if (replaceable && exists) ::fchmod(file.fd_, info.st_mode & 07777);
  return file;
}

AtomicFile::AtomicFile(AtomicFile&& other) noexcept {
  *this = std::move(other);
}

AtomicFile& AtomicFile::operator=(AtomicFile&& other) noexcept {
  if (this == &other) return *this;
  discard();
  shown_name_ = std::move(other.shown_name_);
  target_ = std::move(other.target_);
  temporary_ = std::exchange(other.temporary_, {});
  is_spool_ = other.is_spool_;
  buffer_ = std::exchange(other.buffer_, {});
  fd_ = std::exchange(other.fd_, -1);
  return *this;
}

AtomicFile::~AtomicFile() {
  discard();
}

void AtomicFile::discard() noexcept {
  if (fd_ >= 0) ::close(fd_);
  fd_ = -1;
  if (!temporary_.empty()) ::unlink(temporary_.c_str());
  temporary_.clear();
}

tl::unexpected<Error> AtomicFile::error(const char* doing) const {
  const int reason = errno;
  return fail(reason == ENOENT ? ErrorCode::kNotFound : ErrorCode::kIo,
              shown_name_ + ": " + doing + ": " + std::strerror(reason));
}

Result<void> AtomicFile::open_beside_target() {
  fd_ = open_unnamed(folder_of(target_));
  if (fd_ >= 0) return {};
  for (int attempt = 0; attempt < kNameAttempts; ++attempt) {
    std::string name = temporary_name(target_);
    fd_ = ::open(name.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (fd_ >= 0) {
      temporary_ = std::move(name);
      return {};
    }
    if (errno != EEXIST) break;
  }
  return error("cannot create");
}

Result<void> AtomicFile::open_spool() {
  const char* folder = std::getenv("TMPDIR");
  std::string name = std::string(folder && *folder ? folder : "/tmp") + "/feltline-XXXXXX";
  fd_ = ::mkostemp(name.data(), O_CLOEXEC);
  if (fd_ < 0) return error("cannot create a temporary file");
  ::unlink(name.c_str());
  is_spool_ = true;
  return {};
}

Result<void> AtomicFile::write(std::string_view bytes) {
  buffer_.append(bytes);
  if (buffer_.size() < kBufferBytes) return {};
  return flush();
}

Result<void> AtomicFile::flush() {
  if (!write_all(fd_, buffer_)) return error("cannot write");
  buffer_.clear();
  return {};
}

Result<void> AtomicFile::overwrite(std::uint64_t offset, std::string_view bytes) {
  if (auto ok = flush(); !ok) return ok;
  while (!bytes.empty()) {
    const ssize_t n = ::pwrite(fd_, bytes.data(), bytes.size(), static_cast<off_t>(offset));
    if (n < 0 && errno != EINTR) return error("cannot write");
    if (n > 0) {
      bytes.remove_prefix(static_cast<std::size_t>(n));
      offset += static_cast<std::uint64_t>(n);
    }
  }
  return {};
}

Result<void> AtomicFile::commit() {
  if (auto ok = flush(); !ok) return ok;
  auto done = is_spool_ ? copy_to_target() : replace_target();
  discard();
  return done;
}

Result<void> AtomicFile::copy_to_target() {
  if (::lseek(fd_, 0, SEEK_SET) < 0) return error("cannot rewind");
  if (target_.empty()) std::fflush(stdout);
  const int out =
      target_.empty() ? ::dup(STDOUT_FILENO) : ::open(target_.c_str(), O_WRONLY | O_CLOEXEC);
  if (out < 0) return error("cannot open");
  std::array<char, kBufferBytes> chunk{};
  Result<void> done;
  while (done) {
    const ssize_t n = ::read(fd_, chunk.data(), chunk.size());
    if (n == 0) break;
    if (n < 0 && errno == EINTR) continue;
    if (n < 0 || !write_all(out, {chunk.data(), static_cast<std::size_t>(n)})) {
      done = error("cannot write");
    }
  }
  if (::close(out) != 0 && done) done = error("cannot write");
  return done;
}

Result<void> AtomicFile::replace_target() {
  if (::fsync(fd_) != 0) return error("cannot write to the disk");
  if (auto ok = give_name(); !ok) return ok;
  if (::rename(temporary_.c_str(), target_.c_str()) != 0) return error("cannot replace");
  temporary_.clear();
  // The rename itself survives a power cut only once the folder is on the disk. Some file systems
  // cannot sync a folder and say so by EINVAL; there is nothing more to do then.
  const int folder = ::open(folder_of(target_).c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (folder < 0) return {};
  const bool synced = ::fsync(folder) == 0 || errno == EINVAL;
  ::close(folder);
  return synced ? Result<void>() : error("cannot write the folder to the disk");
}

/// A file without a name cannot replace another in one step: it gets a name of its own first.
Result<void> AtomicFile::give_name() {
  for (int attempt = 0; temporary_.empty() && attempt < kNameAttempts; ++attempt) {
    std::string name = temporary_name(target_);
    if (::linkat(AT_FDCWD, descriptor_path(fd_).c_str(), AT_FDCWD, name.c_str(),
                 AT_SYMLINK_FOLLOW) == 0) {
      temporary_ = std::move(name);
    } else if (errno != EEXIST) {
      break;
    }
  }
  if (temporary_.empty()) return error("cannot create");
  return {};
}

Result<void> write_file(const std::string& path, std::string_view bytes) {
  auto file = AtomicFile::create(path);
  if (!file) return tl::unexpected<Error>(std::move(file.error()));
  if (auto ok = file->write(bytes); !ok) return ok;
  return file->commit();
}

}  // namespace felt
