#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "felt/stroke/stroke.h"

namespace felt {

/// A typed number that names a stroke or layer of a document. Zero names nothing. Ids are never
/// reused within a document, so an id in an undo step always means the same object.
template <class Tag>
struct Id {
  std::uint64_t value = 0;

  /// Returns true if the id is not zero.
  [[nodiscard]] constexpr explicit operator bool() const noexcept { return value != 0; }
  friend constexpr auto operator<=>(Id, Id) noexcept = default;
};

using StrokeId = Id<struct StrokeTag>;
using LayerId = Id<struct LayerTag>;

using StrokePtr = std::shared_ptr<const Stroke>;

/// The place of a stroke: its layer, and its index in that layer's drawing order (0 is the lowest).
struct StrokePlace {
  LayerId layer;
  std::size_t index = 0;

  friend bool operator==(const StrokePlace&, const StrokePlace&) noexcept = default;
};

/// The change of one stroke: added (`before` is null), removed (`after` is null), or replaced.
///
/// Places are absolute: `before_place` is the place in the document before the whole edit,
/// `after_place` the place after the whole edit. So the order of the changes in an edit does not
/// matter, and no change depends on what the others shift. EditBuilder works the places out.
struct StrokeChange {
  StrokeId id;
  StrokePtr before;
  StrokePtr after;
  StrokePlace before_place;  ///< meaningful when before is there
  StrokePlace after_place;   ///< meaningful when after is there

  friend bool operator==(const StrokeChange&, const StrokeChange&) = default;
};

/// How the user sees a layer.
struct LayerState {
  std::string name;
  bool visible = true;
  bool locked = false;  ///< tools leave its strokes alone; undo does not

  friend bool operator==(const LayerState&, const LayerState&) = default;
};

/// The change of one layer: added (`before` is empty), removed (`after` is empty; the same edit
/// must remove or move its strokes), renamed, hidden, locked, or moved. Indices are absolute, like
/// the places of strokes: among the layers before and after the whole edit. 0 is the lowest.
struct LayerChange {
  LayerId id;
  std::optional<LayerState> before;
  std::optional<LayerState> after;
  std::size_t before_index = 0;  ///< meaningful when before is there
  std::size_t after_index = 0;   ///< meaningful when after is there

  friend bool operator==(const LayerChange&, const LayerChange&) = default;
};

/// The only way to change a document: a label for the undo menu, and the changes of strokes and
/// layers. One gesture is one edit.
struct Edit {
  std::string label;  ///< shown to the user: "Draw", "Pull"
  std::vector<StrokeChange> changes;
  std::vector<LayerChange> layers = {};

  [[nodiscard]] bool empty() const noexcept { return changes.empty() && layers.empty(); }
  /// Returns the edit that undoes this one: before and after are swapped. Its inverse is this edit.
  [[nodiscard]] Edit inverse() const;
  friend bool operator==(const Edit&, const Edit&) = default;
};

}  // namespace felt
