#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "felt/base/atomic_file.h"
#include "felt/base/result.h"

namespace felt::cli {

/// An output on the command line. A file gets its name only when it is complete (commit()); until
/// then, and after a failure, the previous file of that name stays. Stdout ("-") and special files
/// (a pipe, /dev/null) are written immediately. A file that the program has read is never replaced:
/// create() then throws a UsageError, and commit() and save() fail.
class Output {
 public:
  /// Creates the output. Fails if the path cannot be written or is a folder. Messages start with
  /// the name.
  static Result<Output> create(const std::string& path);
  /// Creates an output that allows overwrite(). Use it for formats that begin with data that is
  /// known only at the end, such as the length of the file. A special file receives all data in
  /// commit().
  static Result<Output> create_for_overwrite(const std::string& path);
  Output(Output&& other) noexcept;
  ~Output();

  Result<void> write(std::string_view bytes);
  /// Replaces the first bytes of the file. Requires create_for_overwrite().
  Result<void> overwrite(std::string_view bytes);
  /// Completes the file and gives it its name. Fails if the file cannot be written or renamed.
  Result<void> commit();
  /// These functions write the bytes and commit. save() also reads the file back and compares it
  /// with the bytes (save_file). Use save() for a user's work that exists nowhere else.
  Result<void> write_all(std::string_view bytes);
  Result<void> save(std::string_view bytes);

 private:
  explicit Output(std::string name) : name_(std::move(name)) {}
  std::string name_;
  int fd_ = -1;  // file descriptor of an output that is written directly
  std::optional<AtomicFile> file_;
};

}  // namespace felt::cli
