#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "felt/base/result.h"
#include "felt/document/body_edit.h"
#include "felt/document/drawing_guide.h"
#include "felt/document/edit.h"
#include "felt/document/fill.h"
#include "felt/document/layer_table.h"
#include "felt/document/symmetry_group.h"

namespace felt {

/// A table of immutable strokes and fills by id, in layers, and of guides and edits of the body.
/// Only edits change a document, so that undo, autosave and display see the same changes. A copy
/// shares them and takes linear time in their number. Not thread-safe; give other threads a copy.
///
/// Every stroke and every fill is in exactly one layer, once. A document always has at least one
/// layer. The id of a removed object is not reused; all objects but layers share one counter.
/// Guides, symmetry groups and edits of the body are in no layer. Guides, symmetry groups and
/// timings of layers may name strokes that do not exist.
/// The layers of a group are neighbours and have equal groups.
/// Only tools respect locked layers: the document applies every edit that fits, because undo would
/// fail otherwise.
class Document {
 public:
  /// Creates a document with one empty layer, "Ink".
  Document();

  /// Applies an edit completely or not at all. Fails if the edit does not fit this document: a
  /// `before` differs from what the document has, a layer is unknown, a position is beyond the end
  /// or used twice, or there would be more than kMaxDrawingGuides guides or kMaxBodyEdits edits of
  /// the body. The message names the edit, the stroke, fill or layer, and the reason. Takes n log n
  /// time in the changes, and linear time in the strokes and layers above the lowest one that
  /// moves.
  Result<void> apply(const Edit& edit);

  /// Returns the stroke with this id, or null if the document has no such stroke.
  [[nodiscard]] StrokePtr find(StrokeId id) const;
  [[nodiscard]] FillPtr find_fill(FillId id) const;
  [[nodiscard]] DrawingGuidePtr find_guide(GuideId id) const;
  [[nodiscard]] SymmetryPtr find_symmetry(SymmetryId id) const;
  [[nodiscard]] BodyEditPtr find_body_edit(BodyEditId id) const;
  /// Returns the symmetry group of a stroke; an empty id if it has none.
  [[nodiscard]] SymmetryId symmetry_of(StrokeId id) const;
  [[nodiscard]] const std::map<GuideId, DrawingGuidePtr>& guides() const noexcept {
    return guides_;
  }
  [[nodiscard]] const std::map<SymmetryId, SymmetryPtr>& symmetries() const noexcept {
    return symmetries_;
  }
  /// Returns the edits of the body in the order in which they are applied.
  [[nodiscard]] const std::map<BodyEditId, BodyEditPtr>& body_edits() const noexcept {
    return body_edits_;
  }
  /// Returns the guides that are shown and that act on the pen: all of them, or none.
  [[nodiscard]] std::vector<DrawingGuidePtr> visible_guides() const;
  [[nodiscard]] bool shows_guides() const noexcept { return shows_guides_; }
  /// Returns the position of a stroke. Requires that the document has the stroke. Takes linear time
  /// in the strokes above it.
  [[nodiscard]] StrokePlace place(StrokeId id) const;
  [[nodiscard]] StrokePlace fill_place(FillId id) const;
  /// Returns the layer of a stroke. Requires that the document has the stroke.
  [[nodiscard]] LayerId layer_of(StrokeId id) const;
  [[nodiscard]] LayerId layer_of_fill(FillId id) const;
  /// Returns the layers, the lowest first.
  [[nodiscard]] std::span<const Layer> layers() const noexcept { return layers_.layers(); }
  /// Returns the layer with this id, or null if the document has no such layer. Takes constant
  /// time.
  [[nodiscard]] const Layer* layer(LayerId id) const noexcept { return layers_.find(id); }
  [[nodiscard]] std::size_t stroke_count() const noexcept { return strokes_.size(); }
  [[nodiscard]] std::size_t fill_count() const noexcept { return fills_.size(); }
  /// Returns an id that no object of this document (layers apart) ever had: the next unused id, or
  /// the n-th after it. An id counts as used once an edit that adds an object with this id is
  /// applied, even if that edit is undone.
  [[nodiscard]] StrokeId new_id(std::uint64_t n = 0) const noexcept { return {last_id_ + 1 + n}; }
  [[nodiscard]] FillId new_fill_id(std::uint64_t n = 0) const noexcept {
    return {last_id_ + 1 + n};
  }
  [[nodiscard]] GuideId new_guide_id(std::uint64_t n = 0) const noexcept {
    return {last_id_ + 1 + n};
  }
  [[nodiscard]] SymmetryId new_symmetry_id(std::uint64_t n = 0) const noexcept {
    return {last_id_ + 1 + n};
  }
  [[nodiscard]] BodyEditId new_body_edit_id(std::uint64_t n = 0) const noexcept {
    return {last_id_ + 1 + n};
  }
  /// Returns an id that no layer of this document ever had.
  [[nodiscard]] LayerId new_layer_id(std::uint64_t n = 0) const noexcept {
    return {last_layer_id_ + 1 + n};
  }
  /// Returns the index of a layer in layers(); their number if the document has no such layer.
  [[nodiscard]] std::size_t layer_index(LayerId id) const noexcept { return layers_.index_of(id); }
  /// Returns the number of layers that edits have moved in memory so far, for tests of the work.
  [[nodiscard]] std::uint64_t moved_layers() const noexcept { return layers_.moved_count(); }
  /// Returns an id that no group of this document has: one more than the largest, because events
  /// name groups by it, or the smallest free one if files could not have that.
  [[nodiscard]] GroupId new_group_id() const;
  /// Returns the group with this id, or null if no layer is in such a group.
  [[nodiscard]] LayerGroupPtr group(GroupId id) const noexcept;

  /// Marks all ids up to these as used; that of a stroke also counts for fills and guides. Readers
  /// of files call this so that ids used before the drawing was saved are not reused.
  void reserve_ids(StrokeId stroke, LayerId layer) noexcept;

  /// Returns true if the same strokes and fills, by value, are at the same positions in the same
  /// layers, and if the guides, symmetry groups and edits of the body are equal. Whether guides are
  /// shown counts only if there are guides.
  friend bool operator==(const Document& a, const Document& b);

 private:
  template <class T>
  struct Entry {
    std::shared_ptr<const T> object;
    LayerId layer;
  };
  class Plan;

  std::map<StrokeId, Entry<Stroke>> strokes_;
  std::map<FillId, Entry<Fill>> fills_;
  std::map<GuideId, DrawingGuidePtr> guides_;
  std::map<SymmetryId, SymmetryPtr> symmetries_;
  std::map<BodyEditId, BodyEditPtr> body_edits_;
  std::map<StrokeId, SymmetryId> symmetry_of_;
  bool shows_guides_ = true;
  LayerTable layers_;
  std::uint64_t last_id_ = 0;  // of all objects but layers
  std::uint64_t last_layer_id_ = 1;
};

}  // namespace felt
