#include "input.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>
#include <utility>

#include "format.h"

namespace felt::cli {
namespace {

tl::unexpected<Error> cannot_open(int error) {
  const ErrorCode code = error == ENOENT ? ErrorCode::kNotFound : ErrorCode::kIo;
  return fail(code, std::generic_category().message(error));
}

/// A file whose name says that it holds something else would give an error for each of its lines.
Result<void> check_extension(const std::string& path) {
  const std::string name = path.substr(path.find_last_of('/') + 1);
  const std::size_t dot = name.find_last_of('.');
  if (dot == std::string::npos || dot == 0) return {};
  const Result<Format> format = format_of_name(name.substr(dot + 1));
  if (format && *format == Format::kNdjson) return {};
  return fail(ErrorCode::kUnsupported, "cannot read " + name.substr(dot) + ", only .ndjson");
}

}  // namespace

std::string input_name(const std::string& path) {
  return path == "-" ? "stdin" : path;
}

Result<Input> Input::open(const std::string& path) {
  const bool is_stdin = path == "-";
  const int fd = is_stdin ? STDIN_FILENO : ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (fd < 0) return cannot_open(errno);
  Input input(input_name(path), fd, 0);
  struct stat status {};
  if (::fstat(fd, &status) != 0) return cannot_open(errno);
  if (S_ISDIR(status.st_mode)) return cannot_open(EISDIR);
  if (!S_ISREG(status.st_mode)) return input;
  if (Result<void> known = check_extension(path); !known) return tl::unexpected(known.error());
  input.size_bytes_ = status.st_size;
  return input;
}

Input::Input(Input&& other) noexcept
    : name_(std::move(other.name_)),
      fd_(std::exchange(other.fd_, -1)),
      size_bytes_(other.size_bytes_) {}

Input::~Input() {
  if (fd_ > STDERR_FILENO) ::close(fd_);
}

}  // namespace felt::cli
