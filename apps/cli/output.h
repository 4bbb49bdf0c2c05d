#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "felt/base/atomic_file.h"
#include "felt/base/result.h"

namespace felt::cli {

/// An output given on the command line. A file appears under its name only when it is complete
/// (`commit`): until then, and after any failure, what was there before stays. Stdout ("-") and
/// what is no ordinary file (a pipe, /dev/null) are written as the data comes.
class Output {
 public:
  /// Error: the place cannot be written, or is a directory. Messages start with the name.
  static Result<Output> create(const std::string& path);
  /// The same for a file whose beginning is known last: what is no ordinary file gets all of it at
  /// `commit`.
  static Result<Output> create_for_overwrite(const std::string& path);
  Output(Output&& other) noexcept;
  ~Output();

  Result<void> write(std::string_view bytes);
  /// Replaces the first bytes that were written. Requires create_for_overwrite().
  Result<void> overwrite(std::string_view bytes);
  /// Everything is written: makes it the file of that name.
  Result<void> commit();
  /// Both at once. `save` compares a file with these bytes before it counts as written, as for what
  /// a person made and has nowhere else (save_file).
  Result<void> write_all(std::string_view bytes);
  Result<void> save(std::string_view bytes);

 private:
  explicit Output(std::string name) : name_(std::move(name)) {}
  std::string name_;
  int fd_ = -1;  // when written directly
  std::optional<AtomicFile> file_;
};

}  // namespace felt::cli
