#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "felt/base/result.h"
#include "felt/io/limits.h"

namespace felt {

/// Source of bytes: fills the front of the span and returns the number of bytes; 0 at the end of
/// the input.
using ReadBytes = std::function<Result<std::size_t>(std::span<char>)>;

/// Reads from an open file descriptor, which the caller owns. Retries when interrupted.
ReadBytes read_descriptor(int fd);
/// Reads a text in memory, which must outlive the source.
ReadBytes read_text(std::string_view text);

/// One line of an input. Only LineBatch creates lines, so the parser can rely on kLinePadding
/// readable bytes after the text.
class NdjsonLine {
 public:
  /// Returns the line without its terminator; empty if the line was too long to keep.
  [[nodiscard]] std::string_view text() const noexcept { return text_; }
  /// Returns the line number. Lines are counted from 1, and blank lines are counted, too.
  [[nodiscard]] std::int64_t number() const noexcept { return number_; }
  [[nodiscard]] bool too_long() const noexcept { return too_long_; }

 private:
  friend class LineBatch;
  NdjsonLine(std::string_view text, std::int64_t number, bool too_long) noexcept
      : text_(text), number_(number), too_long_(too_long) {}
  std::string_view text_;
  std::int64_t number_;
  bool too_long_;
};

/// Readable bytes after every line, because the JSON parser loads whole vector registers.
inline constexpr std::size_t kLinePadding = 64;

/// Some consecutive lines of one input in one buffer. A worker thread processes one batch at a
/// time. A batch can be reused.
class LineBatch {
 public:
  [[nodiscard]] std::size_t size() const noexcept { return entries_.size(); }
  [[nodiscard]] bool empty() const noexcept { return entries_.empty(); }
  /// Returns line i. Requires i < size(). Valid until the batch changes.
  [[nodiscard]] NdjsonLine line(std::size_t i) const noexcept;
  /// Returns the number of bytes of text in the batch, including padding.
  [[nodiscard]] std::size_t bytes() const noexcept { return text_.size(); }

 private:
  friend class LineReader;
  struct Entry {
    std::size_t begin, size;
    std::int64_t number;
    bool too_long;
  };
  std::string text_;
  std::vector<Entry> entries_;
};

/// Splits a byte stream into lines, a batch at a time. Memory is bounded by the batch and the
/// longest line. Lines end with LF or CR LF; the last line may have no terminator. A byte order
/// mark at the start is dropped. Blank lines are counted but not delivered.
class LineReader {
 public:
  explicit LineReader(ReadBytes read, std::size_t max_line_bytes = limits::kMaxLineBytes);

  /// Replaces the content of `batch` with the next lines: at least one, and further lines until the
  /// batch holds `enough_bytes`. Returns false at the end of the input. If the source fails, the
  /// calls first return the complete lines before the failure, and then the error; an incomplete
  /// line is dropped.
  Result<bool> fill(LineBatch& batch, std::size_t enough_bytes);

  /// Returns the number of bytes read from the source so far.
  [[nodiscard]] std::int64_t bytes_read() const noexcept { return bytes_read_; }

 private:
  bool refill();
  void keep(LineBatch& batch, std::string_view piece);
  void finish_line(LineBatch& batch);

  ReadBytes read_;
  std::size_t max_line_bytes_;
  std::vector<char> block_;
  std::string_view unread_;       // the rest of block_
  std::optional<Error> failure_;  // error of the source; returned after the lines before it
  std::int64_t bytes_read_ = 0;
  std::int64_t line_number_ = 1;
  std::size_t line_begin_ = 0;  // start of the current line in the batch
  bool line_too_long_ = false;
  bool at_start_ = true;
};

}  // namespace felt
