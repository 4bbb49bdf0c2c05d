#pragma once

#include <optional>
#include <string>
#include <vector>

#include "fit_worker.h"
#include "input.h"

namespace felt::cli {

/// Reads all inputs of `fit`, one after the other. If an input consists of lines with strokes, the
/// lines are read in batches, and the workers fit the strokes. An input in another format is read
/// as a whole, and the reader of the format fits the pen samples with the given settings.
class FitSource {
 public:
  FitSource(const std::vector<std::string>& paths, const FitSettings& settings)
      : paths_(paths), settings_(settings) {}

  /// Replaces the content of `item` by the next item. Returns false after the last input. The item
  /// has a failure and no lines if an input cannot be opened or read completely, if it is empty, or
  /// if it contains curves that are already fitted.
  bool next(FitItem& item);

  /// These functions return the progress for the progress line. The total is the size of all inputs
  /// that have been opened so far; an input of unknown size counts as 0.
  [[nodiscard]] std::int64_t bytes_read() const noexcept;
  [[nodiscard]] std::int64_t total_bytes() const noexcept { return total_bytes_; }

 private:
  void open(const std::string& path, FitItem& item);
  void read_whole(FitItem& item);

  const std::vector<std::string>& paths_;
  const FitSettings& settings_;
  std::size_t next_path_ = 0;
  std::optional<Input> input_;
  std::optional<LineReader> reader_;
  std::int64_t records_ = 0;  // records read so far from all inputs
  bool input_is_empty_ = true;
  std::int64_t bytes_of_ended_ = 0;
  std::int64_t total_bytes_ = 0;
};

}  // namespace felt::cli
