#include "fit_source.h"

namespace felt::cli {
namespace {

/// Enough for the cost of handing over not to count, small enough to spread evenly.
constexpr std::size_t kBatchBytes = std::size_t{64} << 10;

}  // namespace

bool FitSource::next(FitItem& item) {
  item.failure.reset();
  for (;;) {
    if (!input_) {
      item.lines = {};
      if (next_path_ == paths_.size()) return false;
      open(paths_[next_path_++], item);
      if (item.failure) return true;
    }
    item.name = input_->name();
    const Result<bool> more = reader_->fill(item.lines, kBatchBytes);
    if (more && *more) {
      input_is_empty_ = false;
      item.first_record = records_ + 1;
      records_ += static_cast<std::int64_t>(item.lines.size());
      return true;
    }
    if (!more) {
      item.failure = more.error();
    } else if (input_is_empty_) {
      item.failure = Error{ErrorCode::kInvalidData, "holds no strokes"};
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
