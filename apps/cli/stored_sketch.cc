#include "stored_sketch.h"

#include <utility>

#include "felt/document/visible_strokes.h"
#include "felt/io/svg_reader.h"
#include "felt/store/felt_file.h"
#include "format.h"

namespace felt::cli {
namespace {

/// None for a name that tells no format.
Format format_or(const std::string& path, Format fallback) {
  return format_of_path(path).value_or(fallback);
}

}  // namespace

bool is_stored_sketch(const std::string& path) {
  const Format format = format_or(path, Format::kNdjson);
  return format == Format::kFelt || format == Format::kSvg;
}

Result<Sketch> read_stored_sketch(const std::string& path) {
  if (format_or(path, Format::kNdjson) == Format::kSvg) {
    return read_svg(path).map([](SvgDrawing drawing) { return std::move(drawing.sketch); });
  }
  return read_felt(path).map(
      [](const StoredDrawing& drawing) { return visible_strokes(drawing.document); });
}

}  // namespace felt::cli
