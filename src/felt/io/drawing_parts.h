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

/// Where the bytes of a file go. Error: they cannot be written.
using ByteSink = std::function<Result<void>(std::string_view bytes)>;

/// A piece of a file.
struct DrawingPart {
  std::string bytes{};
  /// Of a packed part, what it says unpacked: how much, and its checksum.
  std::uint64_t raw_bytes = 0;
  std::uint32_t checksum = 0;
  void clear() {
    bytes.clear();
    raw_bytes = 0;
    checksum = 0;
  }
};

/// A file in the making, in parts of a bounded number of strokes, so that no more than a few of
/// them are in memory. The file is parts 0, 1, ... count() - 1 and then the tail. Parts do not
/// depend on each other, so several threads make them and the bytes are the same for any number of
/// threads. Valid as long as the drawing that it was made of, which must not change.
class DrawingParts {
 public:
  virtual ~DrawingParts() = default;

  [[nodiscard]] virtual std::size_t count() const = 0;
  /// Replaces `out` by part i. Error: a stroke that the format cannot hold, by its number.
  virtual Result<void> make(std::size_t i, DrawingPart& out) const = 0;
  /// Whether parts may be made by several threads and in any order; else one thread makes them in
  /// order.
  [[nodiscard]] virtual bool any_order() const { return true; }
  /// Notes a part that went to the file. Called for each in order, on one thread.
  virtual void add(const DrawingPart&) {}
  /// What follows the last part. Call once, after the last add().
  virtual std::string tail() { return {}; }
};

/// Makes all parts on the calling thread and gives them to the sink.
Result<void> write_parts(DrawingParts& parts, const ByteSink& sink);
/// The same as one string.
Result<std::string> bytes_of(DrawingParts& parts);

/// Strokes [first, last) of a layer, which is named by its index in the document.
struct StrokeRange {
  std::size_t layer = 0, first = 0, last = 0;
  /// Strokes before `first`, those of lower layers that are written included.
  std::size_t before = 0;
};

/// Strokes and control points of a part, apart from a single larger stroke.
inline constexpr std::size_t kPartStrokes = 128;
inline constexpr std::size_t kPartPoints = 8192;

/// Cuts the strokes of these layers into ranges for one part each, in order. A layer without
/// strokes has one empty range.
std::vector<StrokeRange> stroke_ranges(const Document& document, LayerChoice layers);

/// Returns the part of the page that a picture shows: `page`, or else the ink and `margin_mm`
/// around it, with its edges rounded outwards to 0.01 mm.
Rect picture_area(const Rect& ink, const std::optional<Rect>& page, double margin_mm) noexcept;

/// Parts that are a text, as one gzip file: each part is packed for itself. It holds neither a time
/// nor a name.
std::unique_ptr<DrawingParts> gzip_parts(std::unique_ptr<DrawingParts> text);

}  // namespace felt
