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

/// How a drawing is written. Each counts where the format can say it (FormatTraits).
struct WriteOptions {
  /// The part of the sheet that a picture shows (.svg, .pdf, .png); without it, the page.
  std::optional<Rect> area{};
  /// Behind the ink, in place of the page's colour; alpha 0 leaves it out.
  std::optional<Rgba> paper{};
  double dpi = 300.0;  ///< of a .png
  Grain grain{};       ///< the relief of the sheet in the ink of a .png
  /// The same of an .svg or .pdf, whose strokes stay outlines (GrainPrint); none: it is not shown.
  std::optional<GrainPrint> grain_print{};
};

/// A drawing as a file in the making: what drawing_bytes() gives, in parts that several threads may
/// make, without all of it in memory (.felt and .png are one part). Valid as long as the drawing.
Result<std::unique_ptr<DrawingParts>> drawing_parts(const Drawing& drawing, FileFormat format,
                                                    const WriteOptions& options = {});

/// A drawing as the bytes of a file. Formats with layers keep hidden ones hidden; all others hold
/// what is seen. Equal drawings give equal bytes. Error: what the format cannot hold, or a format
/// that is not written; the message does not name a file. Any thread.
Result<std::string> drawing_bytes(const Drawing& drawing, FileFormat format,
                                  const WriteOptions& options = {});

/// Writes it whole or not at all, and durably; "-" is stdout. Error: begins with the path, and what
/// was there before is as it was. Any thread.
Result<void> write_drawing(const std::string& path, const Drawing& drawing, FileFormat format,
                           const WriteOptions& options = {});

}  // namespace felt
