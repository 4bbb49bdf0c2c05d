#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "felt/document/document.h"

namespace felt {

/// Says of many strokes what each is divided into, again and again while a gesture lasts: previews
/// of erasing and cutting at 1 kHz. The parts of a stroke, none, one or several, stand where it
/// stood in the drawing order and are new strokes.
///
///   StrokeDivisions cut;
///   cut.set(document, id, {left, right});      // as often as the parts change
///   Edit preview = cut.build(document, "Erase");
///
/// The document must not change from the first set() to the last build(). The places of strokes
/// are looked up once each. A stroke that the document does not have must not be named.
class StrokeDivisions {
 public:
  /// From now on the stroke is divided into these, the first the lowest. The first time for a
  /// stroke: logarithmic where the ids of its layer ascend, else linear in it.
  void set(const Document& document, StrokeId id, std::vector<StrokePtr> parts);
  /// It stays whole after all.
  void unset(StrokeId id);
  void clear() noexcept;

  [[nodiscard]] bool empty() const noexcept { return divided_.empty(); }
  /// Strokes and parts: the changes that build() makes.
  [[nodiscard]] std::size_t size() const noexcept { return divided_.size() + parts_; }
  /// Linear in the strokes and their parts, whatever the size of the document. New ids are given in
  /// drawing order, so the edit depends on the parts only and not on the order of the calls.
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
