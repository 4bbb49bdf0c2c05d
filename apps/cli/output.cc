#include "output.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>
#include <utility>

#include "commands.h"
#include "felt/base/check.h"
#include "felt/base/input_files.h"

namespace felt::cli {
namespace {

/// Returns true for a pipe, a terminal or a device, because a finished file cannot replace it.
bool is_written_directly(const std::string& path) {
  struct stat status {};
  return ::stat(path.c_str(), &status) == 0 && !S_ISREG(status.st_mode) && !S_ISDIR(status.st_mode);
}

/// Creates a file. Throws a UsageError if that would overwrite an input.
Result<AtomicFile> create_file(const std::string& path) {
  Result<AtomicFile> file = AtomicFile::create(path);
  if (!file && input_file_at(path)) throw UsageError(file.error().message);
  return file;
}

}  // namespace

Result<Output> Output::create(const std::string& path) {
  Output output(path == "-" ? "stdout" : path);
  if (path == "-") {
    output.fd_ = STDOUT_FILENO;
    return output;
  }
  if (is_written_directly(path)) {
    output.fd_ = ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
    if (output.fd_ >= 0) return output;
    return fail(ErrorCode::kIo, path + ": " + std::generic_category().message(errno));
  }
  Result<AtomicFile> file = create_file(path);
  if (!file) return tl::unexpected(file.error());
  output.file_ = *std::move(file);
  return output;
}

Result<Output> Output::create_for_overwrite(const std::string& path) {
  Result<AtomicFile> file = create_file(path);
  if (!file) return tl::unexpected(file.error());
  Output output(path);
  output.file_ = *std::move(file);
  return output;
}

Output::Output(Output&& other) noexcept
    : name_(std::move(other.name_)),
      fd_(std::exchange(other.fd_, -1)),
      file_(std::move(other.file_)) {}

Output::~Output() {
  if (fd_ > STDERR_FILENO) ::close(fd_);
}

Result<void> Output::write(std::string_view bytes) {
  if (file_) return file_->write(bytes);
  while (!bytes.empty()) {
    const ssize_t written = ::write(fd_, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) {
      return fail(ErrorCode::kIo, name_ + ": " + std::generic_category().message(errno));
    }
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return {};
}

Result<void> Output::overwrite(std::string_view bytes) {
  FELT_CHECK(file_.has_value());
  return file_->overwrite(0, bytes);
}

Result<void> Output::commit() {
  if (!file_) return {};
  return file_->commit();
}

Result<void> Output::write_all(std::string_view bytes) {
  if (Result<void> written = write(bytes); !written) return written;
  return commit();
}

Result<void> Output::save(std::string_view bytes) {
  if (Result<void> written = write(bytes); !written || !file_) return written;
  return file_->commit_verified(bytes);
}

}  // namespace felt::cli
