#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "felt/document/blend_mode.h"
#include "felt/document/id.h"
#include "felt/document/key_timing.h"
#include "felt/document/layer_group.h"
#include "felt/document/layer_picture.h"
#include "felt/stroke/stroke.h"

namespace felt {

using StrokePtr = std::shared_ptr<const Stroke>;
struct Fill;  // fill.h
using FillPtr = std::shared_ptr<const Fill>;
struct DrawingGuide;  // drawing_guide.h
using DrawingGuidePtr = std::shared_ptr<const DrawingGuide>;
struct SymmetryGroup;  // symmetry_group.h
using SymmetryPtr = std::shared_ptr<const SymmetryGroup>;
struct BodyEdit;  // body_edit.h
using BodyEditPtr = std::shared_ptr<const BodyEdit>;

/// The position of a stroke or fill: its layer, and its index in that layer's list of strokes or of
/// fills (0 is the lowest).
struct StrokePlace {
  LayerId layer;
  std::size_t index = 0;

  friend bool operator==(const StrokePlace&, const StrokePlace&) noexcept = default;
};

/// The change of one stroke: added (`before` is null), removed (`after` is null), or replaced.
///
/// Positions are absolute: `before_place` is the position in the document before the whole edit,
/// and `after_place` is the position after the whole edit. So the order of the changes in an edit
/// does not matter. EditBuilder computes the positions.
struct StrokeChange {
  StrokeId id;
  StrokePtr before;
  StrokePtr after;
  StrokePlace before_place;  ///< used only if `before` is set
  StrokePlace after_place;   ///< used only if `after` is set

  friend bool operator==(const StrokeChange&, const StrokeChange&) = default;
};

/// The change of one fill: added, removed, or replaced, as in StrokeChange.
struct FillChange {
  FillId id;
  FillPtr before;
  FillPtr after;
  StrokePlace before_place;  ///< used only if `before` is set
  StrokePlace after_place;   ///< used only if `after` is set

  friend bool operator==(const FillChange&, const FillChange&) = default;
};

/// The change of one guide: added, removed, or replaced. Guides are above all layers, and their
/// order is that of their ids.
struct GuideChange {
  GuideId id;
  DrawingGuidePtr before;
  DrawingGuidePtr after;

  friend bool operator==(const GuideChange&, const GuideChange&) = default;
};

/// The change of one symmetry group: added, removed, or replaced.
struct SymmetryChange {
  SymmetryId id;
  SymmetryPtr before;
  SymmetryPtr after;

  friend bool operator==(const SymmetryChange&, const SymmetryChange&) = default;
};

/// The change of one edit of the body: added, removed, or replaced. Edits of the body are in no
/// layer, and their order is that of their ids.
struct BodyEditChange {
  BodyEditId id;
  BodyEditPtr before;
  BodyEditPtr after;

  friend bool operator==(const BodyEditChange&, const BodyEditChange&) = default;
};

/// Longest name of a layer or of a group of layers, in bytes of UTF-8. Files have no longer ones.
inline constexpr std::size_t kMaxLayerNameBytes = 4096;

/// Everything about a layer except its strokes, its fills and its position.
struct LayerState {
  std::string name;
  bool visible = true;
  bool locked = false;           ///< tools do not change its strokes; undo can
  double opacity = 1.0;          ///< 0..1, of the layer as a whole: its strokes do not show through
  LayerPicturePtr picture = {};  ///< below the strokes; null for most layers
  BlendMode blend = BlendMode::kNormal;  ///< of the layer as a whole with what is below it
  LayerGroupPtr group = {};              ///< null if the layer is in no group
  KeyTimingPtr timing = {};              ///< as a key drawing; null: that of a new key drawing

  /// Compares by value.
  friend bool operator==(const LayerState& a, const LayerState& b) {
    return a.name == b.name && a.visible == b.visible && a.locked == b.locked &&
           a.opacity == b.opacity && a.blend == b.blend && equal_groups(a.group, b.group) &&
           equal_timings(a.timing, b.timing) &&
           (a.picture == b.picture || (a.picture && b.picture && *a.picture == *b.picture));
  }
};

/// Return true if the layer and its group are visible, and if the layer or its group is locked.
[[nodiscard]] inline bool is_visible(const LayerState& layer) noexcept {
  return layer.visible && (!layer.group || layer.group->visible);
}
[[nodiscard]] inline bool is_locked(const LayerState& layer) noexcept {
  return layer.locked || (layer.group && layer.group->locked);
}

/// The change of one layer: added (`before` is empty), removed (`after` is empty; the same edit
/// must remove or move its strokes and fills), moved, or given another state. Indices are absolute,
/// like the positions of strokes: `before_index` is the index before the whole edit, `after_index`
/// the index after it. Index 0 is the lowest layer.
struct LayerChange {
  LayerId id;
  std::optional<LayerState> before;
  std::optional<LayerState> after;
  std::size_t before_index = 0;  ///< used only if `before` is set
  std::size_t after_index = 0;   ///< used only if `after` is set

  friend bool operator==(const LayerChange&, const LayerChange&) = default;
};

/// The only way to change a document: a label for the undo menu, and the changes of strokes,
/// layers, fills, guides, symmetry groups and edits of the body. One gesture is one edit.
struct Edit {
  std::string label;  ///< shown to the user: "Draw", "Pull"
  std::vector<StrokeChange> changes;
  std::vector<LayerChange> layers = {};
  std::vector<FillChange> fills = {};
  std::vector<GuideChange> guides = {};
  std::vector<SymmetryChange> symmetries = {};
  std::vector<BodyEditChange> body_edits = {};
  bool toggles_guides = false;  ///< hides the guides if they were shown, shows them if hidden

  [[nodiscard]] bool empty() const noexcept {
    return changes.empty() && layers.empty() && fills.empty() && guides.empty() &&
           symmetries.empty() && body_edits.empty() && !toggles_guides;
  }
  /// Returns the edit that undoes this edit: `before` and `after` are swapped. The inverse of the
  /// result is this edit.
  [[nodiscard]] Edit inverse() const;
  friend bool operator==(const Edit&, const Edit&) = default;
};

}  // namespace felt
