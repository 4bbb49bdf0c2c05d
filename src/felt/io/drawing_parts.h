#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "felt/base/result.h"
#include "felt/document/drawing.h"
#include "felt/document/visible_strokes.h"

namespace felt {

/// Receives the bytes of a file. Fails if they cannot be written.
using ByteSink = std::function<Result<void>(std::string_view bytes)>;

/// A piece of a file.
struct DrawingPart {
  std::string bytes{};
  /// Size and checksum of the bytes before packing; used only in packed parts.
  std::uint64_t raw_bytes = 0;
  std::uint32_t checksum = 0;
  void clear() {
    bytes.clear();
    raw_bytes = 0;
    checksum = 0;
  }
};

/// A file that is being written. It is divided into parts with a bounded number of strokes, so that
/// only a few parts are in memory at a time. The file consists of the parts 0, 1, ... count() - 1,
/// followed by the tail. Parts do not depend on each other (if any_order() is true), so several
/// threads can make them; the bytes are the same for any number of threads. The drawing must exist
/// and must not change while its parts are made.
class DrawingParts {
 public:
  virtual ~DrawingParts() = default;

  [[nodiscard]] virtual std::size_t count() const = 0;
  /// Replaces the content of `out` with part i. Fails if the format cannot represent a stroke; the
  /// message contains the number of the stroke.
  virtual Result<void> make(std::size_t i, DrawingPart& out) const = 0;
  /// Returns true if several threads may make parts, in any order. Otherwise one thread makes them
  /// in order.
  [[nodiscard]] virtual bool any_order() const { return true; }
  /// Records that a part was written to the file. Called for each part in order, on one thread.
  virtual void add(const DrawingPart&) {}
  /// Returns the bytes after the last part. Must be called once, after the last add().
  virtual std::string tail() { return {}; }
};

/// Makes all parts on the calling thread and passes them to `sink`.
Result<void> write_parts(DrawingParts& parts, const ByteSink& sink);
/// Makes all parts and returns the file as one string.
Result<std::string> bytes_of(DrawingParts& parts);

/// Strokes [first, last) of a layer. `layer` is its index in the document.
struct StrokeRange {
  std::size_t layer = 0, first = 0, last = 0;
  /// Number of strokes before `first`, including those of the lower layers that are written.
  std::size_t before = 0;
};

/// Maximum number of strokes and of control points in a part. A single stroke with more control
/// points becomes a separate part.
inline constexpr std::size_t kPartStrokes = 128;
inline constexpr std::size_t kPartPoints = 8192;

/// Divides the strokes of these layers into ranges, one for each part of the file, in the order of
/// the file. A layer without strokes gets one empty range.
std::vector<StrokeRange> stroke_ranges(const Document& document, LayerChoice layers);

/// Returns the area that a picture shows. This is `page`; if `page` is nullopt, it is the box
/// around the ink with a margin of `margin_mm`, with its edges rounded outwards to 0.01 mm.
Rect picture_area(const Rect& ink, const std::optional<Rect>& page, double margin_mm) noexcept;

/// Packs text parts into one gzip file. Each part is packed separately. The file contains no time
/// and no name.
std::unique_ptr<DrawingParts> gzip_parts(std::unique_ptr<DrawingParts> text);

}  // namespace felt
