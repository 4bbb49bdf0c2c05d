#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "felt/base/result.h"
#include "felt/io/drawing_parts.h"
#include "felt/io/import.h"
#include "felt/io/ndjson/ndjson_parser.h"
#include "felt/stroke/fit/ink_fitter.h"
#include "felt/stroke/named_stroke.h"

namespace felt {

/// Makes a stroke from a line of JSON (docs/formats/ndjson.md). Reads a fitted stroke exactly as
/// given, and fits a stroke to raw pen samples (in mm), of kSolidMedium (solid_fit()). One object
/// can read many lines; each result depends only on its line. Not thread-safe.
class LineStrokes {
 public:
  explicit LineStrokes(const InkFitOptions& fit = {}) : fitter_(solid_fit(fit)) {}

  /// Returns the stroke of a line, or nullopt for a header. The id of the stroke is "" if the line
  /// has no id. Fails if the line is not a stroke.
  Result<std::optional<NamedStroke>> read(const NdjsonLine& line);
  /// Returns true if the stroke of the last line had rounded coordinates that were corrected
  /// (mend_rounding).
  [[nodiscard]] bool was_mended() const noexcept { return was_mended_; }
  /// Returns the faults of the samples of the last line; none if it was not raw.
  [[nodiscard]] const SampleFaults& faults() const noexcept { return faults_; }

 private:
  Result<std::optional<NamedStroke>> read_fitted(const NdjsonLine& line);
  Result<std::optional<NamedStroke>> read_raw(const NdjsonLine& line);

  NdjsonParser parser_;
  InkFitter fitter_;
  RawStroke raw_;
  bool was_mended_ = false;
  SampleFaults faults_;
};

/// The message about strokes whose rounded coordinates were corrected, reported once per file.
inline constexpr const char* kMendedNotice =
    "has rounded coordinates; smooth joints were moved by less than 0.001 mm or became corners";

/// Reads lines of JSON (docs/formats/ndjson.md) into a drawing with one layer and no page. Reads
/// fitted strokes exactly as given, and fits strokes to raw pen samples (in mm). A line that is not
/// a stroke is skipped and reported. A stroke without an id gets the name stroke_name(n) if it is
/// record n of the file, counted from 1 (docs/formats/ndjson.md).
///
/// If the text has lines but none of them could be read, fails with the first error. Also fails if
/// the lines are events.
Result<Imported> import_lines(std::string_view text, const ImportOptions& options = {});

/// Returns the strokes of visible layers as lines, in parts, without a header
/// (docs/formats/ndjson.md). Valid as long as `drawing` exists.
std::unique_ptr<DrawingParts> line_parts(const Drawing& drawing);

}  // namespace felt
