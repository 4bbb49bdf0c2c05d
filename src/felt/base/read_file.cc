#include "felt/base/read_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "felt/base/input_files.h"

namespace felt {
namespace {

constexpr std::size_t kChunkBytes = std::size_t{1} << 18;

tl::unexpected<Error> system_error(const std::string& name, int reason) {
  return fail(reason == ENOENT ? ErrorCode::kNotFound : ErrorCode::kIo,
              name + ": cannot read: " + std::strerror(reason));
}

tl::unexpected<Error> too_large(const std::string& name, std::size_t max_bytes) {
  return fail(ErrorCode::kLimitExceeded,
              name + ": is larger than " + std::to_string(max_bytes) + " bytes");
}

/// Returns the size of a regular file, else 0.
std::uint64_t size_of(int fd) {
  struct stat info {};
  if (::fstat(fd, &info) != 0 || !S_ISREG(info.st_mode)) return 0;
  return static_cast<std::uint64_t>(info.st_size);
}

/// Appends one chunk at most. Returns false at the end of the file.
Result<bool> read_chunk(int fd, const std::string& name, std::string& bytes) {
  for (;;) {
    const std::size_t have = bytes.size();
    bytes.resize(have + kChunkBytes);
    const ssize_t n = ::read(fd, bytes.data() + have, kChunkBytes);
    const int reason = errno;
    bytes.resize(have + (n > 0 ? static_cast<std::size_t>(n) : 0));
    if (n >= 0) return n > 0;
    if (reason != EINTR) return system_error(name, reason);
  }
}

Result<std::string> read_all(int fd, const std::string& name, const HeadCheck& check) {
  note_input_file(fd, name);
  const std::uint64_t size = size_of(fd);
  std::string bytes;
  Result<bool> more = true;
  while (more && *more && bytes.size() < kCheckedHeadBytes) more = read_chunk(fd, name, bytes);
  if (!more) return tl::unexpected(more.error());
  const auto max_bytes = check(std::string_view(bytes).substr(0, kCheckedHeadBytes), size);
  if (!max_bytes) return tl::unexpected(with_context(max_bytes.error(), name));
  if (size > *max_bytes) return too_large(name, *max_bytes);
  // Reserves one chunk more than the file, so that the last read, which finds the end, does not
  // reallocate.
  if (size > 0) bytes.reserve(static_cast<std::size_t>(size) + kChunkBytes);
  while (more && *more && bytes.size() <= *max_bytes) more = read_chunk(fd, name, bytes);
  if (!more) return tl::unexpected(more.error());
  if (bytes.size() > *max_bytes) return too_large(name, *max_bytes);
  return bytes;
}

HeadCheck at_most(std::size_t max_bytes) {
  return [max_bytes](std::string_view, std::uint64_t) { return max_bytes; };
}

}  // namespace

Result<std::string> read_file(const std::string& path, const HeadCheck& check) {
  if (path == "-") return read_all(STDIN_FILENO, "stdin", check);
  const int fd = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (fd < 0) return system_error(path, errno);
  Result<std::string> bytes = read_all(fd, path, check);
  ::close(fd);
  return bytes;
}

Result<std::string> read_file(const std::string& path, std::size_t max_bytes) {
  return read_file(path, at_most(max_bytes));
}

Result<std::string> read_regular_file(const std::string& path, const HeadCheck& check) {
  // O_NONBLOCK, because opening a pipe would wait for its writer.
  const int fd = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NOCTTY | O_NONBLOCK);
  if (fd < 0) return system_error(path, errno);
  Result<std::string> bytes = fail(ErrorCode::kUnsupported, path + ": not a regular file");
  struct stat info {};
  // A folder is also read, because the error of read(2) says that it is a folder.
  if (::fstat(fd, &info) == 0 && (S_ISREG(info.st_mode) || S_ISDIR(info.st_mode))) {
    bytes = read_all(fd, path, check);
  }
  ::close(fd);
  return bytes;
}

Result<std::string> read_regular_file(const std::string& path, std::size_t max_bytes) {
  return read_regular_file(path, at_most(max_bytes));
}

}  // namespace felt
