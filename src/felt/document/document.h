#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "felt/base/result.h"
#include "felt/document/edit.h"

namespace felt {

/// A layer: strokes in drawing order, and how the user sees it.
struct Layer {
  LayerId id;
  std::string name;
  bool visible = true;
  bool locked = false;
  std::vector<StrokeId> strokes;  ///< the lowest first
};

/// A table of immutable strokes by id, in layers. Changes by edits only, so that undo, autosave and
/// the display all see the same thing. Copies are cheap in strokes (shared) and linear in their
/// number. One thread; snapshots go to others by copy.
class Document {
 public:
  /// One empty layer, "Ink".
  Document();

  /// Carries an edit out, all of it or nothing. Error: it does not fit this document (a `before`
  /// that is not there, an unknown layer, a place beyond the end).
  Result<void> apply(const Edit& edit);

  /// The stroke, or null.
  [[nodiscard]] StrokePtr find(StrokeId id) const;
  /// Where it stands. Requires that it is there.
  [[nodiscard]] StrokePlace place(StrokeId id) const;
  [[nodiscard]] std::span<const Layer> layers() const noexcept { return layers_; }
  [[nodiscard]] std::size_t stroke_count() const noexcept { return strokes_.size(); }
  /// An id that no stroke of this document ever had; the n-th after the next for n > 0. It is taken
  /// once an edit that makes it is applied.
  [[nodiscard]] StrokeId new_id(std::uint64_t n = 0) const noexcept;

 private:
  std::map<StrokeId, StrokePtr> strokes_;
  std::vector<Layer> layers_;
  std::uint64_t last_id_ = 0;
};

}  // namespace felt
