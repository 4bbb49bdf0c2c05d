#pragma once

#include <cstdio>
#include <functional>
#include <memory>
#include <string_view>

#include "felt/io/ndjson/ndjson_lines.h"
#include "felt/stroke/sketch.h"

namespace felt::cli {

using TakeStroke = std::function<Result<void>(const SketchStroke&)>;

/// Gives every stroke of a source of our own lines to `take`; stops at the first error.
Result<void> for_each_line_stroke(ReadBytes source, const TakeStroke& take);

/// Keeps the strokes of a sketch in a temporary file that has no name, so that a picture of it can
/// be begun when its bounds are known, without holding all strokes in memory.
class SketchSpool {
 public:
  /// Adds strokes, given as the lines of the ndjson writer.
  Result<void> add_lines(std::string_view lines);

  /// Gives every stroke to `take`, in the order added.
  Result<void> for_each(const TakeStroke& take);

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  std::unique_ptr<std::FILE, Close> file_;  // opened by the first line
};

}  // namespace felt::cli
