#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "felt/formats/drawing_reader.h"
#include "felt/io/ndjson/ndjson_lines.h"

namespace felt::cli {

/// An input on the command line: a file, a pipe, or stdin as "-". The destructor closes it. The
/// first bytes are read immediately to detect the format. The rest is read when it is requested,
/// and can be read only once.
class Input {
 public:
  /// Opens an input. Fails if the file is missing, unreadable, a folder, or of an unsupported
  /// format. The message contains only the reason, not the name.
  static Result<Input> open(const std::string& path);
  /// Opens an input that is named inside a file, such as an import of a script. Fails like open(),
  /// and also if the input is not a regular file, because a pipe could block.
  static Result<Input> open_regular(const std::string& path);
  Input(Input&& other) noexcept;
  ~Input();

  /// Returns the name for errors: the path as given, or "stdin".
  [[nodiscard]] const std::string& name() const noexcept { return name_; }
  /// Returns the size in bytes if it is known in advance, else 0.
  [[nodiscard]] std::int64_t size_bytes() const noexcept { return size_bytes_; }
  [[nodiscard]] FileFormat format() const noexcept { return format_; }
  /// Returns true if the input is a text whose lines contain strokes. Such lines can be read one by
  /// one; other inputs are read as a whole.
  [[nodiscard]] bool is_lines() const noexcept { return is_lines_; }
  /// Returns true if each line of the input contains a Quick, Draw! drawing. `fit` also reads such
  /// lines one by one.
  [[nodiscard]] bool is_quickdraw() const noexcept { return is_quickdraw_; }
  /// Returns a function that reads all bytes. The Input object must not be moved while the function
  /// is used.
  [[nodiscard]] ReadBytes reader() const;
  /// Reads the whole input as a drawing. Fails if the input is not a readable drawing; the message
  /// contains only the reason, not the name.
  [[nodiscard]] Result<Imported> read_drawing(const ReadOptions& options) const;

 private:
  Input(std::string name, int fd) noexcept : name_(std::move(name)), fd_(fd) {}
  static Result<Input> begin(const std::string& path, int fd, bool regular_only);
  [[nodiscard]] Result<std::string> read_all(std::size_t max_bytes) const;
  /// Adds to the error of a damaged .felt file that it can be salvaged.
  [[nodiscard]] tl::unexpected<Error> with_salvage_hint(Error error,
                                                        const ReadOptions& options) const;
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

/// Returns true if a drawing contains neither strokes nor fills nor pictures.
bool is_blank(const Document& document) noexcept;

/// Returns "stdin" for "-", and otherwise the path.
std::string input_name(const std::string& path);

}  // namespace felt::cli
