#include "fit_source.h"

#include <algorithm>
#include <string_view>

namespace felt::cli {
namespace {

/// The size of a batch. It is large enough that the cost of passing a batch is negligible, and
/// small enough that the work is distributed evenly.
constexpr std::size_t kFitBatchBytes = std::size_t{64} << 10;

/// Returns true if the first stroke is already a curve. The input then contains a sketch, not pen
/// samples.
bool is_sketch(const LineBatch& lines) {
  for (std::size_t i = 0; i < std::min<std::size_t>(lines.size(), 2); ++i) {  // line 0 may be a
                                                                              // header
    const std::string_view text = lines.line(i).text();
    if (text.find("\"points\"") != std::string_view::npos) return false;
    if (text.find("\"segments\"") != std::string_view::npos) return true;
  }
  return false;
}

}  // namespace

bool FitSource::next(FitItem& item) {
  item.failure.reset();
  item.drawing.reset();
  item.drawing_bytes = 0;
  for (;;) {
    if (!input_) {
      item.lines = {};
      if (next_path_ == paths_.size()) return false;
      open(paths_[next_path_++], item);
      if (item.failure) return true;
    }
    item.name = input_->name();
    if (!input_->is_lines() && !input_->is_quickdraw()) {
      read_whole(item);
      return true;
    }
    const Result<bool> more = reader_->fill(item.lines, kFitBatchBytes);
    if (more && *more) {
      if (input_is_empty_ && is_sketch(item.lines)) {
        item.failure = Error{ErrorCode::kUnsupported,
                             "contains curves, which are already fitted; use convert"};
        item.lines = {};
        input_.reset();
        return true;
      }
      input_is_empty_ = false;
      item.first_record = records_ + 1;
      records_ += static_cast<std::int64_t>(item.lines.size());
      return true;
    }
    if (!more) {
      item.failure = more.error();
    } else if (input_is_empty_) {
      item.failure = Error{ErrorCode::kInvalidData, "contains no strokes"};
    }
    bytes_of_ended_ += reader_->bytes_read();
    input_.reset();
    item.lines = {};
    if (item.failure) return true;
  }
}

std::int64_t FitSource::bytes_read() const noexcept {
  return bytes_of_ended_ + (input_ ? reader_->bytes_read() : 0);
}

void FitSource::read_whole(FitItem& item) {
  const auto fails = [&item](ErrorCode code, const std::string& why) {
    item.failure = Error{code, why};
  };
  item.lines = {};
  Result<Imported> opened = input_->read_drawing({.import = {.fit = settings_.ink}});
  bytes_of_ended_ += input_->size_bytes();
  const auto size = static_cast<std::size_t>(input_->size_bytes());
  input_.reset();
  if (!opened) {
    item.failure = opened.error();
  } else if (opened->is_exact) {
    fails(ErrorCode::kUnsupported, "contains curves, which are already fitted; use convert");
  } else if (settings_.steady) {
    fails(ErrorCode::kUnsupported, "is not raw .ndjson, the only format that --steady supports");
  } else if (settings_.measure) {
    fails(ErrorCode::kUnsupported, "is not raw .ndjson, the only format that --stats supports");
  } else {
    item.first_record = records_ + 1;
    records_ += static_cast<std::int64_t>(opened->drawing.document.stroke_count());
    item.drawing = *std::move(opened);
    item.drawing_bytes = size;
  }
}

void FitSource::open(const std::string& path, FitItem& item) {
  Result<Input> input = Input::open(path);
  item.name = input_name(path);
  if (!input) {
    item.failure = input.error();
    return;
  }
  input_.emplace(*std::move(input));
  reader_.emplace(input_->reader());
  input_is_empty_ = true;
  total_bytes_ += input_->size_bytes();
}

}  // namespace felt::cli
