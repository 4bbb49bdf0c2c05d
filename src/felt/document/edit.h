#pragma once

#include <memory>
#include <string>
#include <vector>

#include "felt/base/id.h"
#include "felt/stroke/stroke.h"

namespace felt {

using StrokePtr = std::shared_ptr<const Stroke>;

/// Where a stroke stands: its layer, and its place in that layer's drawing order (0 is the lowest).
struct StrokePlace {
  LayerId layer;
  std::size_t index = 0;

  friend bool operator==(const StrokePlace&, const StrokePlace&) noexcept = default;
};

/// What becomes of one stroke: made (before is null), removed (after is null), or replaced.
struct StrokeChange {
  StrokeId id;
  StrokePtr before;
  StrokePtr after;
  StrokePlace before_place;  ///< meaningful when before is there
  StrokePlace after_place;   ///< meaningful when after is there

  friend bool operator==(const StrokeChange&, const StrokeChange&) = default;
};

/// The one kind of change of a document: a label for the undo menu and what becomes of which
/// stroke. Its inverse swaps before and after and runs backwards. One gesture is one edit.
struct Edit {
  std::string label;  ///< "Draw", "Pull": for people
  std::vector<StrokeChange> changes;

  [[nodiscard]] bool empty() const noexcept { return changes.empty(); }
  /// Undoes this edit when applied after it.
  [[nodiscard]] Edit inverse() const;
  friend bool operator==(const Edit&, const Edit&) = default;
};

}  // namespace felt
