#include "felt/base/atomic_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <utility>

#include "felt/base/file_steps.h"
#include "felt/base/input_files.h"

namespace felt {

using namespace file_steps;

namespace {

constexpr std::size_t kBufferBytes = std::size_t{1} << 16;

}  // namespace

Result<AtomicFile> AtomicFile::create(const std::string& path) {
  Result<AtomicFile> file = create_for_save(path);
  if (!file) return file;
  file->keeps_inputs_ = true;
  if (Result<void> ok = file->check_not_read(); !ok) return tl::unexpected(ok.error());
  return file;
}

Result<AtomicFile> AtomicFile::create_for_save(const std::string& path) {
  if (path.empty()) return fail(ErrorCode::kInvalidArgument, "the file name is empty");
  AtomicFile file;
  file.shown_name_ = path == "-" ? "stdout" : path;
  if (path != "-") file.target_ = resolved(path);
  struct stat info {};
  const bool exists = path != "-" && ::stat(file.target_.c_str(), &info) == 0;
  // If stat fails for another reason than ENOENT, the file may exist: don't treat it as missing.
  if (path != "-" && !exists && errno != ENOENT) return file.error("cannot access");
  const bool replaceable = path != "-" && (!exists || S_ISREG(info.st_mode));
  if (exists && S_ISDIR(info.st_mode)) {
    errno = EISDIR;
    return file.error("cannot write");
  }
  // The new file never has wider permissions than the old one, even if a later step fails.
  const unsigned permissions = exists ? info.st_mode & 0777 : 0666;
  auto ok = replaceable ? file.open_beside_target(permissions) : file.open_spool();
  if (ok && replaceable && exists) ok = file.take_after_target();
  if (!ok) return tl::unexpected<Error>(std::move(ok.error()));
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
  previous_ = std::exchange(other.previous_, {});
  is_spool_ = other.is_spool_;
  keeps_inputs_ = other.keeps_inputs_;
  buffer_ = std::exchange(other.buffer_, {});
  fd_ = std::exchange(other.fd_, -1);
  old_fd_ = std::exchange(other.old_fd_, -1);
  return *this;
}

AtomicFile::~AtomicFile() {
  discard();
}

void AtomicFile::discard() noexcept {
  if (!temporary_.empty()) ::unlink(temporary_.c_str());
  temporary_.clear();
  for (int* fd : {&fd_, &old_fd_}) {
    if (*fd >= 0) ::close(std::exchange(*fd, -1));
  }
}

tl::unexpected<Error> AtomicFile::error(const char* doing) const {
  const int reason = errno;
  return fail(reason == ENOENT ? ErrorCode::kNotFound : ErrorCode::kIo,
              shown_name_ + ": " + doing + ": " + std::strerror(reason));
}

Result<void> AtomicFile::open_beside_target(unsigned permissions) {
  fd_ = open_unnamed(folder_of(target_), permissions);
  if (fd_ < 0) fd_ = open_named(target_, permissions, temporary_);
  if (fd_ >= 0) {
    hold_lock(fd_);
    return {};
  }
  const bool is_refused = errno == EACCES || errno == EPERM || errno == EROFS;
  return error(is_refused ? "no permission to write to its folder" : "cannot create");
}

/// A rename would replace a read-only file, because it needs permission for the folder only. So
/// check the permission of the file itself.
Result<void> AtomicFile::take_after_target() {
  if (::access(target_.c_str(), W_OK) != 0) return error("no permission to write");
  old_fd_ = open_file(target_, O_RDONLY);
  if (old_fd_ < 0) return {};  // writable but not readable: no attributes to copy
  hold_lock(old_fd_);
  copy_attributes(old_fd_, fd_);
  return {};
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
  return commit(nullptr);
}

Result<void> AtomicFile::commit_verified(std::string_view bytes) {
  return commit(&bytes);
}

Result<void> AtomicFile::commit(const std::string_view* expected) {
  if (auto ok = flush(); !ok) return ok;
  auto done = is_spool_ ? copy_to_target() : replace_target(expected);
  discard();
  if (done && !is_spool_) remove_leftovers(target_, expected != nullptr);
  return done;
}

Result<void> AtomicFile::copy_to_target() {
  if (::lseek(fd_, 0, SEEK_SET) < 0) return error("cannot rewind");
  if (target_.empty()) std::fflush(stdout);
  const int out = target_.empty() ? ::dup(STDOUT_FILENO) : open_file(target_, O_WRONLY);
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

Result<void> AtomicFile::replace_target(const std::string_view* expected) {
  if (::fsync(fd_) != 0) return error("cannot write to the disk");
  if (temporary_.empty()) temporary_ = give_name(fd_, target_);
  if (temporary_.empty()) return error("cannot create");
  if (!expected) return put_in_place();
  if (!holds(temporary_, *expected)) {
    if (errno != 0) return error("cannot read back the written data");
    return fail(ErrorCode::kIo, shown_name_ + ": the disk does not keep the data written to it");
  }
  // The second name is an extra: rename() itself is atomic. If it cannot be created, save without
  // it.
  if (old_fd_ >= 0) previous_ = keep_beside(target_);
  return put_in_place().and_then([&] { return check_in_place(*expected); });
}

Result<void> AtomicFile::check_not_read() const {
  if (!keeps_inputs_ || is_spool_) return {};
  const std::optional<std::string> input = input_file_at(target_);
  if (!input) return {};
  return fail(ErrorCode::kInvalidArgument, shown_name_ + ": would overwrite the input " + *input +
                                               "; it was not written. Choose another file");
}

Result<void> AtomicFile::put_in_place() {
  // A file that was read since create() counts, too.
  if (Result<void> ok = check_not_read(); !ok) {
    if (!previous_.empty()) ::unlink(previous_.c_str());
    return ok;
  }
  if (::rename(temporary_.c_str(), target_.c_str()) != 0) {
    const auto failed = error("cannot replace");
    if (!previous_.empty()) ::unlink(previous_.c_str());  // the old file still has its own name
    return failed;
  }
  temporary_.clear();
  // The rename survives a power cut only once the folder is on the disk. If this fails, the second
  // name of the old file stays, and the next verified save removes it.
  if (!sync_folder(folder_of(target_))) return error("cannot write the folder to the disk");
  return {};
}

Result<void> AtomicFile::check_in_place(std::string_view expected) {
  if (holds(target_, expected)) {
    if (!previous_.empty()) ::unlink(previous_.c_str());
    return {};
  }
  // If another program has replaced our file in the meantime, its file is newer: don't restore the
  // old file.
  struct stat ours {
  }, there{};
  const bool is_ours = ::fstat(fd_, &ours) == 0 && ::stat(target_.c_str(), &there) == 0 &&
                       ours.st_ino == there.st_ino && ours.st_dev == there.st_dev;
  if (!is_ours && errno == 0) {
    if (!previous_.empty()) ::unlink(previous_.c_str());
    return fail(ErrorCode::kIo, shown_name_ + ": was replaced by another program just now");
  }
  std::string message = shown_name_ + ": the disk does not keep the data written to it";
  if (errno != 0) message += std::string(": ") + std::strerror(errno);
  const bool is_back = !previous_.empty() && ::rename(previous_.c_str(), target_.c_str()) == 0 &&
                       sync_folder(folder_of(target_));
  return fail(ErrorCode::kIo, message + (is_back ? "; the previous file was restored" : ""));
}

Result<void> write_file(const std::string& path, std::string_view bytes) {
  auto file = AtomicFile::create(path);
  if (!file) return tl::unexpected<Error>(std::move(file.error()));
  if (auto ok = file->write(bytes); !ok) return ok;
  return file->commit();
}

Result<void> save_file(const std::string& path, std::string_view bytes) {
  auto file = AtomicFile::create_for_save(path);
  if (!file) return tl::unexpected<Error>(std::move(file.error()));
  if (auto ok = file->write(bytes); !ok) return ok;
  return file->commit_verified(bytes);
}

}  // namespace felt
