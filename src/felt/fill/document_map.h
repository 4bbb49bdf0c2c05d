#pragma once

#include "felt/document/document.h"
#include "felt/fill/fill_map.h"

namespace felt {

/// The map of the strokes of a document. It is built at the first question, and each further
/// question updates it by the strokes that differ since then.
class DocumentMap {
 public:
  /// Which strokes the map has.
  enum class Of : std::uint8_t { kAllStrokes, kVisibleStrokes };

  explicit DocumentMap(Of strokes) : strokes_(strokes) {}

  /// The largest number of strokes of a map, because its first update takes quadratic time.
  static constexpr std::size_t kMaxStrokes = 2'000;

  /// Returns the map of the document as it is after `edit`, valid until the next call. In a
  /// document of more than kMaxStrokes strokes the map has only those that reach `area`. Returns
  /// null if these are more than kMaxStrokes, too.
  FillMap* after(const Document& document, const Edit& edit, const Rect& area);

 private:
  Of strokes_;
  FillMap map_;
};

}  // namespace felt
