#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "felt/document/document.h"

namespace felt {

/// Builds edits that divide strokes into parts. It is so fast that it can build a new edit for each
/// sample of a gesture, for previews of erasing and cutting at 1 kHz. A stroke is divided into
/// zero, one or several parts, which are new strokes at its position in the drawing order.
///
///   StrokeDivisions cut;
///   cut.set(document, id, {left, right});      // as often as the parts change
///   Edit preview = cut.build(document, "Erase");
///
/// The document must not change from the first set() to the last build(). The position of each
/// stroke is looked up only once. Requires that the document has every stroke that is passed.
class StrokeDivisions {
 public:
  /// Sets the parts of a stroke, the lowest first. Replaces the parts that an earlier call set for
  /// this stroke. The first call for a stroke takes logarithmic time in the size of its layer if
  /// the ids in the layer ascend, otherwise linear time.
  void set(const Document& document, StrokeId id, std::vector<StrokePtr> parts);
  /// Removes the parts of the stroke, so that the edit does not divide it.
  void unset(StrokeId id);
  void clear() noexcept;

  [[nodiscard]] bool empty() const noexcept { return divided_.empty(); }
  /// Returns the number of changes that build() makes: the number of divided strokes plus the
  /// number of parts.
  [[nodiscard]] std::size_t size() const noexcept { return divided_.size() + parts_; }
  /// Returns the edit. Takes linear time in the number of divided strokes and parts, independent of
  /// the size of the document. New ids are given in drawing order, so the edit depends only on the
  /// parts and not on the order of the calls.
  [[nodiscard]] Edit build(const Document& document, std::string label) const;

 private:
  using Place = std::pair<LayerId, std::size_t>;
  struct Division {
    StrokeId id;
    StrokePtr before;
    std::vector<StrokePtr> parts;
  };

  std::map<StrokeId, Place> places_;
  std::map<Place, Division> divided_;
  std::size_t parts_ = 0;
};

}  // namespace felt
