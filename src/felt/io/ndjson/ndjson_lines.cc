#include "felt/io/ndjson/ndjson_lines.h"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <system_error>

namespace felt {
namespace {

constexpr std::size_t kBlockBytes = std::size_t{256} << 10;
constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

bool is_blank(std::string_view line) {
  return line.find_first_not_of(" \t\r") == std::string_view::npos;
}

}  // namespace

ReadBytes read_descriptor(int fd) {
  return [fd](std::span<char> into) -> Result<std::size_t> {
    ssize_t got = 0;
    do {
      got = ::read(fd, into.data(), into.size());
    } while (got < 0 && errno == EINTR);
    if (got < 0) {
      return fail(ErrorCode::kIo, "cannot read: " + std::generic_category().message(errno));
    }
    return static_cast<std::size_t>(got);
  };
}

ReadBytes read_text(std::string_view text) {
  return [text](std::span<char> into) mutable -> Result<std::size_t> {
    const std::size_t count = std::min(into.size(), text.size());
    std::copy_n(text.data(), count, into.data());
    text.remove_prefix(count);
    return count;
  };
}

NdjsonLine LineBatch::line(std::size_t i) const noexcept {
  const Entry& entry = entries_[i];
  return {std::string_view(text_).substr(entry.begin, entry.size), entry.number, entry.too_long};
}

LineReader::LineReader(ReadBytes read, std::size_t max_line_bytes)
    : read_(std::move(read)), max_line_bytes_(max_line_bytes), block_(kBlockBytes) {}

Result<bool> LineReader::fill(LineBatch& batch, std::size_t enough_bytes) {
  batch.text_.clear();
  batch.entries_.clear();
  line_begin_ = 0;
  while (batch.empty() || line_begin_ < enough_bytes) {  // a batch ends only between two lines
    if (unread_.empty() && !refill()) {
      if (!failure_) finish_line(batch);
      batch.text_.resize(line_begin_);
      if (failure_ && batch.empty()) return tl::unexpected(*failure_);
      break;
    }
    const std::size_t newline = unread_.find('\n');
    keep(batch, unread_.substr(0, newline));
    if (newline == std::string_view::npos) {
      unread_ = {};
      continue;
    }
    unread_.remove_prefix(newline + 1);
    finish_line(batch);
  }
  batch.text_.append(kLinePadding, '\0');
  return !batch.empty();
}

bool LineReader::refill() {
  if (failure_) return false;
  const Result<std::size_t> got = read_(block_);
  if (!got) {
    failure_ = got.error();
    return false;
  }
  bytes_read_ += static_cast<std::int64_t>(*got);
  unread_ = std::string_view(block_.data(), *got);
  return *got > 0;
}

void LineReader::keep(LineBatch& batch, std::string_view piece) {
  if (line_too_long_) return;
  // One byte beyond the limit may be the CR of the terminator.
  if (batch.text_.size() - line_begin_ + piece.size() > max_line_bytes_ + 1) {
    line_too_long_ = true;
    batch.text_.resize(line_begin_);
    return;
  }
  batch.text_ += piece;
}

void LineReader::finish_line(LineBatch& batch) {
  std::string_view line = std::string_view(batch.text_).substr(line_begin_);
  if (at_start_ && line.substr(0, kByteOrderMark.size()) == kByteOrderMark) {
    line.remove_prefix(kByteOrderMark.size());
  }
  if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
  const bool too_long = line_too_long_ || line.size() > max_line_bytes_;
  if (too_long) line = line.substr(0, 0);
  const auto begin = static_cast<std::size_t>(line.data() - batch.text_.data());
  if (too_long || !is_blank(line)) {
    batch.entries_.push_back({begin, line.size(), line_number_, too_long});
    batch.text_.resize(begin + line.size());
  } else {
    batch.text_.resize(line_begin_);
  }
  line_begin_ = batch.text_.size();
  line_too_long_ = false;
  at_start_ = false;
  ++line_number_;
}

}  // namespace felt
