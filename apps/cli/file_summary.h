#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "felt/formats/drawing_reader.h"
#include "felt/geometry/rect.h"
#include "felt/io/ndjson/ndjson_record.h"
#include "felt/stroke/stroke.h"

namespace felt::cli {

/// The information about a file that `info` shows.
struct FileSummary {
  bool is_sketch = false;  ///< if false, the file contains raw pen strokes
  FileFormat format = FileFormat::kNdjson;
  std::optional<Imported> opened;  ///< for formats that are read as a whole
  std::int64_t strokes = 0;
  Rect bounds;  ///< of the ink in mm, or of the samples in the file's unit

  // The following members are set for a sketch.
  std::int64_t segments = 0;
  std::int64_t corners = 0;
  std::int64_t closed = 0;
  std::int64_t width_knots = 0;
  double min_width_mm = 0.0, max_width_mm = 0.0;

  // The following members are set for raw pen strokes.
  std::int64_t samples = 0;
  std::int64_t longest = 0;  ///< number of samples of the longest stroke
  /// Number of strokes in which at least one sample has a pressure, or a time.
  std::int64_t with_pressure = 0, with_time = 0;

  void add(const Stroke& stroke);
  void add(const RawStroke& stroke);
};

/// Returns the summary for people: some lines of "name value".
std::string summary_text(const FileSummary& summary);
/// Returns the summary for programs: one line of JSON, keys in a fixed order.
std::string summary_json(const FileSummary& summary);

}  // namespace felt::cli
