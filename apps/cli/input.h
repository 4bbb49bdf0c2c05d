#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "felt/formats/drawing_reader.h"
#include "felt/io/ndjson/ndjson_lines.h"

namespace felt::cli {

/// An input given on the command line: a file, a pipe, or stdin as "-". Closes what it opened. Its
/// first bytes are read at once and say what it is; the rest comes as it is asked for, once.
class Input {
 public:
  /// Error: missing, not readable, a folder, or of a format that is not read. The message is the
  /// reason alone.
  static Result<Input> open(const std::string& path);
  /// The same for a name out of a file, an import of a script. Error also if it is not a regular
  /// file: a pipe would be waited for.
  static Result<Input> open_regular(const std::string& path);
  Input(Input&& other) noexcept;
  ~Input();

  /// What errors call it: the path as given, or "stdin".
  [[nodiscard]] const std::string& name() const noexcept { return name_; }
  /// Size in bytes when it is known beforehand, else 0.
  [[nodiscard]] std::int64_t size_bytes() const noexcept { return size_bytes_; }
  [[nodiscard]] FileFormat format() const noexcept { return format_; }
  /// Lines of strokes, which need not be held in memory together; anything else is read as a whole.
  [[nodiscard]] bool is_lines() const noexcept { return is_lines_; }
  /// Lines of drawings of Quick, Draw!, which fit takes one by one as well.
  [[nodiscard]] bool is_quickdraw() const noexcept { return is_quickdraw_; }
  /// The bytes from the first on. The input must stay where it is while they are read.
  [[nodiscard]] ReadBytes reader() const;
  /// All of it, as a drawing. The message of an error is the reason alone.
  [[nodiscard]] Result<Imported> read_drawing(const ReadOptions& options) const;

 private:
  Input(std::string name, int fd) noexcept : name_(std::move(name)), fd_(fd) {}
  static Result<Input> begin(const std::string& path, int fd, bool regular_only);
  [[nodiscard]] Result<std::string> read_all(std::size_t most) const;
  Result<void> read_head();
  Result<void> find_kind(const std::string& path);

  std::string name_;
  int fd_ = -1;
  std::int64_t size_bytes_ = 0;
  std::string head_;
  FileFormat format_ = FileFormat::kNdjson;
  bool is_lines_ = true;
  bool is_quickdraw_ = false;
};

/// "stdin" for "-", else the path.
std::string input_name(const std::string& path);

}  // namespace felt::cli
