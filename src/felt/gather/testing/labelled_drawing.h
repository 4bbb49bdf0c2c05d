#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "felt/base/result.h"
#include "felt/gather/line_sections.h"

namespace felt {

/// Rough strokes, each with the number of the strip that it belongs to.
struct LabelledDrawing {
  std::string name;
  double pen_width = 1.0;
  std::vector<RoughLine> lines;  ///< in the units of the file
  std::vector<std::uint32_t> labels;

  /// Returns the diagonal of the box of all points.
  [[nodiscard]] double diagonal() const;
};

/// Reads a .scap file of StrokeStrip (https://github.com/davepagurek/StrokeStrip): "#WIDTH HEIGHT",
/// "@PEN", then for each stroke "{", "#ID LABEL", "@PEN", lines "X Y 0", "}". Fails if the file
/// cannot be read or a line has another form.
Result<LabelledDrawing> read_scap(const std::string& path);

/// Reads all .scap files of a folder, sorted by name. Fails if there are none or one is damaged.
Result<std::vector<LabelledDrawing>> read_scap_folder(const std::string& folder);

}  // namespace felt
