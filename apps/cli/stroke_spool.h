#pragma once

#include <cstdio>
#include <functional>
#include <memory>
#include <string_view>

#include "felt/base/result.h"
#include "felt/stroke/named_stroke.h"

namespace felt::cli {

/// Collects strokes in an unnamed temporary file, so that they do not have to be in memory
/// together.
class StrokeSpool {
 public:
  /// Adds strokes in the form of lines from append_sketch_line().
  Result<void> add_lines(std::string_view lines);

  /// Calls `handle` with each stroke in the order in which they were added. Stops at the first
  /// error and returns it.
  Result<void> for_each(const std::function<Result<void>(NamedStroke)>& handle);

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  std::unique_ptr<std::FILE, Close> file_;  // opened when the first line is added
};

}  // namespace felt::cli
