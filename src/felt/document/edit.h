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

/// A typed number that names a thing of a document. Zero names nothing. Ids are never reused
/// within a document, so an id in an undo step still means the same thing later.
template <class Tag>
struct Id {
  std::uint64_t value = 0;

  /// True when the id names something.
  [[nodiscard]] constexpr explicit operator bool() const noexcept { return value != 0; }
  friend constexpr auto operator<=>(Id, Id) noexcept = default;
};

using StrokeId = Id<struct StrokeTag>;
using LayerId = Id<struct LayerTag>;

using StrokePtr = std::shared_ptr<const Stroke>;

/// Where a stroke stands: its layer, and its place in that layer's drawing order (0 is the lowest).
struct StrokePlace {
  LayerId layer;
  std::size_t index = 0;

  friend bool operator==(const StrokePlace&, const StrokePlace&) noexcept = default;
};

/// What becomes of one stroke: made (before is null), removed (after is null), or replaced.
///
/// Places are absolute: `before_place` is where it stands in the document before the whole edit,
/// `after_place` where it stands after the whole edit. So the order of the changes in an edit means
/// nothing, and no change has to know what the others shift. EditBuilder works the places out.
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

/// What becomes of one layer: made (before is empty), removed (after is empty; its strokes must be
/// removed or moved by the same edit), renamed, hidden, locked, or moved. Indices are absolute, as
/// places of strokes are: among the layers before and after the whole edit, 0 is the lowest.
struct LayerChange {
  LayerId id;
  std::optional<LayerState> before;
  std::optional<LayerState> after;
  std::size_t before_index = 0;  ///< meaningful when before is there
  std::size_t after_index = 0;   ///< meaningful when after is there

  friend bool operator==(const LayerChange&, const LayerChange&) = default;
};

/// The one kind of change of a document: a label for the undo menu and what becomes of which
/// stroke or layer. One gesture is one edit.
struct Edit {
  std::string label;  ///< "Draw", "Pull": for people
  std::vector<StrokeChange> changes;
  std::vector<LayerChange> layers = {};

  [[nodiscard]] bool empty() const noexcept { return changes.empty() && layers.empty(); }
  /// Undoes this edit when applied after it: before and after swapped. Its inverse is this edit.
  [[nodiscard]] Edit inverse() const;
  friend bool operator==(const Edit&, const Edit&) = default;
};

}  // namespace felt
