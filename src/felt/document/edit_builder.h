#pragma once

#include <string>
#include <vector>

#include "felt/document/document.h"

namespace felt {

/// Builds an edit that fits a document, and computes the positions of its strokes and fills:
///
///   EditBuilder edit(document);
///   edit.remove(old);
///   edit.add(layer, stroke);
///   Edit done = std::move(edit).build("Erase");
///
/// The document must not change before build(). Replace or remove each stroke and each fill at most
/// once.
class EditBuilder {
 public:
  explicit EditBuilder(const Document& document) noexcept : document_(document) {}

  /// Adds a new stroke on top of its layer, above the strokes that were added before it. Returns
  /// its id. Requires that the document has the layer.
  StrokeId add(LayerId layer, StrokePtr stroke);
  /// Replaces a stroke with another shape at the same position. Requires that the document has the
  /// stroke.
  void replace(StrokeId id, StrokePtr stroke);
  /// Removes a stroke. Requires that the document has the stroke.
  void remove(StrokeId id);

  /// These do the same for fills: add one on top of the fills of its layer, replace one, remove
  /// one.
  FillId add_fill(LayerId layer, FillPtr fill);
  void replace_fill(FillId id, FillPtr fill);
  void remove_fill(FillId id);

  /// Returns the edit. Takes linear time in the number of changes and in the size of the changed
  /// layers.
  [[nodiscard]] Edit build(std::string label) &&;

 private:
  const Document& document_;
  std::vector<StrokeChange> changes_;
  std::vector<FillChange> fills_;
  std::uint64_t made_ = 0;
};

/// Builds edits that replace the same stroke repeatedly during a gesture. Looks up the stroke's
/// position only once, so previews at 1 kHz are possible in a layer of 10^5 strokes. The document
/// must not change while this object is used.
class StrokeReplacement {
 public:
  /// Looks up the stroke in linear time in the size of its layer. Requires that the document has
  /// the stroke.
  StrokeReplacement(const Document& document, StrokeId id);

  [[nodiscard]] StrokeId id() const noexcept { return id_; }
  /// Returns the stroke as it is in the document.
  [[nodiscard]] const StrokePtr& before() const noexcept { return before_; }
  /// Returns an edit that replaces the stroke with `after` at the same position, or removes the
  /// stroke if `after` is null.
  [[nodiscard]] Edit with(StrokePtr after, std::string label) const;

 private:
  StrokeId id_;
  StrokePtr before_;
  StrokePlace place_;
};

}  // namespace felt
