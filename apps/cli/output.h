#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "felt/base/atomic_file.h"
#include "felt/base/result.h"

namespace felt::cli {

/// An output on the command line. A file appears under its name only when it is complete
/// (`commit`); until then, and after any failure, the previous file stays. Stdout ("-") and special
/// files (a pipe, /dev/null) are written as the data arrives.
class Output {
 public:
  /// Fails if the path cannot be written, or is a folder. Messages start with the name.
  static Result<Output> create(const std::string& path);
  /// Same, for a file whose first bytes are known only at the end. A special file receives all data
  /// at `commit`.
  static Result<Output> create_for_overwrite(const std::string& path);
  Output(Output&& other) noexcept;
  ~Output();

  Result<void> write(std::string_view bytes);
  /// Replaces the first bytes of the file. Requires create_for_overwrite().
  Result<void> overwrite(std::string_view bytes);
  /// Completes the file and gives it its name.
  Result<void> commit();
  /// Writes and commits. `save` also reads the file back and compares it with these bytes; it is
  /// for a user's work that exists nowhere else (save_file).
  Result<void> write_all(std::string_view bytes);
  Result<void> save(std::string_view bytes);

 private:
  explicit Output(std::string name) : name_(std::move(name)) {}
  std::string name_;
  int fd_ = -1;  // if written directly
  std::optional<AtomicFile> file_;
};

}  // namespace felt::cli
