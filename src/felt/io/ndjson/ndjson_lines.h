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

/// Source of bytes: fills the front of the span and returns how many; 0 is the end of the input.
using ReadBytes = std::function<Result<std::size_t>(std::span<char>)>;

/// Bytes from an open file descriptor, which stays the caller's. Retries when interrupted.
ReadBytes read_descriptor(int fd);
/// Bytes of a text in memory, which must outlive the source.
ReadBytes read_text(std::string_view text);

/// One line of an input. Only a LineBatch makes them, which proves to the parser that kLinePadding
/// readable bytes follow the text.
class NdjsonLine {
 public:
  /// Without terminator; empty when the line was too long to keep.
  [[nodiscard]] std::string_view text() const noexcept { return text_; }
  /// Counted from 1, blank lines included.
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

/// Readable bytes behind every line; the JSON parser loads whole vector registers.
inline constexpr std::size_t kLinePadding = 64;

/// Some consecutive lines of one input, held together: what a worker gets to do. Reusable.
class LineBatch {
 public:
  [[nodiscard]] std::size_t size() const noexcept { return entries_.size(); }
  [[nodiscard]] bool empty() const noexcept { return entries_.empty(); }
  /// Line i. Requires i < size(). Valid until the batch changes.
  [[nodiscard]] NdjsonLine line(std::size_t i) const noexcept;
  /// Bytes of text held, padding included.
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

/// Splits a byte stream into lines, a batch at a time, with memory bounded by the batch and the
/// longest line. Ends of line are LF or CR LF; the last line may lack one. A byte order mark at the
/// start is dropped, blank lines are counted but not delivered.
class LineReader {
 public:
  explicit LineReader(ReadBytes read, std::size_t max_line_bytes = limits::kMaxLineBytes);

  /// Replaces the content of `batch` by the next lines: at least one, and no more once
  /// `enough_bytes` are held. False at the end of the input. An error of the source is returned
  /// after the whole lines before it were delivered; the line that it cuts is dropped.
  Result<bool> fill(LineBatch& batch, std::size_t enough_bytes);

  /// Bytes taken from the source so far.
  [[nodiscard]] std::int64_t bytes_read() const noexcept { return bytes_read_; }

 private:
  bool refill();
  void keep(LineBatch& batch, std::string_view piece);
  void finish_line(LineBatch& batch);

  ReadBytes read_;
  std::size_t max_line_bytes_;
  std::vector<char> block_;
  std::string_view unread_;       // what is left of block_
  std::optional<Error> failure_;  // of the source; delivered after the lines before it
  std::int64_t bytes_read_ = 0;
  std::int64_t line_number_ = 1;
  std::size_t line_begin_ = 0;  // where the line in work starts in the batch
  bool line_too_long_ = false;
  bool at_start_ = true;
};

}  // namespace felt
