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

  /// A map of a whole document has at most this many strokes. With so many, the first map takes
  /// half a second, and an edit less than a tenth (fill_bench).
  static constexpr std::size_t kMaxStrokes = 10'000;
  /// The largest number of strokes near an area. The first map of 100,000 takes six seconds.
  static constexpr std::size_t kMaxNearStrokes = 100'000;

  /// Returns the map of the document as it is after `edit`, valid until the next call. In a
  /// document of more than kMaxStrokes strokes the map has only those that reach `area`. Returns
  /// null if these are more than kMaxNearStrokes.
  FillMap* after(const Document& document, const Edit& edit, const Rect& area);

 private:
  Of strokes_;
  FillMap map_;
};

}  // namespace felt
