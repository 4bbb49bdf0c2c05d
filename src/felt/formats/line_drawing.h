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

/// Makes a stroke of a line of JSON (docs/formats/ndjson.md): a fitted one as it is, raw pen
/// samples in mm as ink. Reusable; what comes of a line depends on that line alone. One thread.
class LineStrokes {
 public:
  explicit LineStrokes(const InkFitOptions& fit = {}) : fitter_(fit) {}

  /// None for a header. The id is "" where the line has none. Error: the line is no stroke.
  Result<std::optional<NamedStroke>> read(const NdjsonLine& line);
  /// True if the stroke of the last line had rounded coordinates that were mended (mend_rounding).
  [[nodiscard]] bool was_mended() const noexcept { return was_mended_; }

 private:
  Result<std::optional<NamedStroke>> read_fitted(const NdjsonLine& line);
  Result<std::optional<NamedStroke>> read_raw(const NdjsonLine& line);

  NdjsonParser parser_;
  InkFitter fitter_;
  RawStroke raw_;
  bool was_mended_ = false;
};

/// What to say about strokes whose rounded coordinates were mended, once a file.
inline constexpr const char* kMendedNotice =
    "has rounded coordinates; smooth joints were moved by less than 0.001 mm or became corners";

/// Reads lines of JSON (docs/formats/ndjson.md): fitted strokes as they are, raw pen samples in mm
/// as ink, one layer, no sheet. A line that is no stroke becomes a notice, and the rest is taken.
/// Strokes without a name are called after their line's number among the strokes.
///
/// Error: nothing could be taken though there are lines (the first reason), or they hold events.
Result<Imported> import_lines(std::string_view text, const ImportOptions& options = {});

/// Whether the first line says what the file is.
enum class LineHeader { kWritten, kLeftOut };

/// The strokes of visible layers as lines, in parts.
std::unique_ptr<DrawingParts> line_parts(const Drawing& drawing,
                                         LineHeader header = LineHeader::kWritten);

}  // namespace felt
