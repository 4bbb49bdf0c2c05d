#pragma once

#include <cstdio>
#include <functional>
#include <memory>
#include <string_view>

#include "felt/base/result.h"
#include "felt/stroke/named_stroke.h"

namespace felt::cli {

/// Keeps strokes in an unnamed temporary file until the last one was added, so that not all of them
/// are in memory.
class StrokeSpool {
 public:
  /// Adds strokes, as lines of append_sketch_line.
  Result<void> add_lines(std::string_view lines);

  /// Calls `handle` with each stroke in the order added; stops at the first error.
  Result<void> for_each(const std::function<Result<void>(NamedStroke)>& handle);

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  std::unique_ptr<std::FILE, Close> file_;  // opened for the first line
};

}  // namespace felt::cli
