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

  /// Returns the map of the document as it is after `edit`. The reference is valid until the next
  /// call.
  FillMap& after(const Document& document, const Edit& edit = {});

 private:
  Of strokes_;
  FillMap map_;
};

}  // namespace felt
