#pragma once

#include <memory>
#include <optional>
#include <string>

#include "felt/base/result.h"
#include "felt/document/drawing.h"
#include "felt/formats/file_format.h"
#include "felt/geometry/rect.h"
#include "felt/render/grain.h"

namespace felt {

class DrawingParts;

/// Options for writing a drawing. A format ignores the options that it does not support
/// (FormatTraits).
struct WriteOptions {
  /// Area that a picture shows (.svg, .pdf, .png), in mm. If absent, the picture shows the page.
  std::optional<Rect> area{};
  /// Background colour instead of the page's colour. If alpha is 0, no background is drawn.
  std::optional<Rgba> paper{};
  double dpi = 300.0;  ///< resolution of a .png file
  /// Pictures of layers that .png and .svg files show.
  PictureChoice pictures = PictureChoice::kMarked;
  Grain grain{};  ///< how the surface shows in the ink of a .png file
  /// How the surface shows in the ink of .svg and .pdf files. Their strokes are outlines with or
  /// without the grain (GrainPrint). If absent, the grain is not shown.
  std::optional<GrainPrint> grain_print{};
  /// Write an .svg file for web pages: only the visible ink as outlines, without grain
  /// (svg_compact_text).
  bool compact = false;
};

/// Returns the content of a file in parts, so that several threads can make the parts and only a
/// few of them are in memory (.felt and .png have one part). All parts together equal the result of
/// drawing_bytes(). The result is valid as long as `drawing` exists. Fails under the same
/// conditions as drawing_bytes().
Result<std::unique_ptr<DrawingParts>> drawing_parts(const Drawing& drawing, FileFormat format,
                                                    const WriteOptions& options = {});

/// Returns a drawing as the bytes of a file. Formats with layers contain all layers, and the hidden
/// ones remain hidden; other formats contain only visible layers. Equal drawings give equal bytes.
/// Fails if the drawing cannot be written in this format with these options. The message does not
/// name a file. Safe to call from any thread.
Result<std::string> drawing_bytes(const Drawing& drawing, FileFormat format,
                                  const WriteOptions& options = {});

/// Writes a drawing completely or not at all, and durably. The path "-" is stdout. If writing
/// fails, an existing file is unchanged, and the message begins with the path. Safe to call from
/// any thread.
Result<void> write_drawing(const std::string& path, const Drawing& drawing, FileFormat format,
                           const WriteOptions& options = {});

}  // namespace felt
