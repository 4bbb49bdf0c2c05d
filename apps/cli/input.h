#pragma once

#include <cstdint>
#include <string>

#include "felt/io/ndjson_lines.h"

namespace felt::cli {

/// An input given on the command line: a file, or stdin as "-". Closes what it opened.
class Input {
 public:
  /// Error: missing, not readable, a directory, a file with the extension of another format. The
  /// message is the reason alone.
  static Result<Input> open(const std::string& path);
  Input(Input&& other) noexcept;
  ~Input();

  /// What errors call it: the path as given, or "stdin".
  [[nodiscard]] const std::string& name() const noexcept { return name_; }
  /// Size in bytes when it is known beforehand, else 0.
  [[nodiscard]] std::int64_t size_bytes() const noexcept { return size_bytes_; }
  [[nodiscard]] ReadBytes reader() const { return read_descriptor(fd_); }

 private:
  Input(std::string name, int fd, std::int64_t size_bytes) noexcept
      : name_(std::move(name)), fd_(fd), size_bytes_(size_bytes) {}
  std::string name_;
  int fd_ = -1;
  std::int64_t size_bytes_ = 0;
};

/// "stdin" for "-", else the path.
std::string input_name(const std::string& path);

}  // namespace felt::cli
