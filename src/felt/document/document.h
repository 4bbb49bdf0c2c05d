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

  [[nodiscard]] LayerState state() const { return {name, visible, locked}; }
  friend bool operator==(const Layer&, const Layer&) = default;
};

/// A table of immutable strokes by id, in layers. Changes by edits only, so that undo, autosave and
/// the display all see the same thing. Copies are cheap in strokes (shared) and linear in their
/// number. One thread; snapshots go to others by copy.
///
/// Every stroke stands in exactly one layer, once; there is at least one layer; an id never comes
/// to name another stroke. Locked layers are a matter between tools and people: the document
/// itself takes every edit that fits, or undo would get stuck.
class Document {
 public:
  /// One empty layer, "Ink".
  Document();

  /// Carries an edit out, all of it or nothing. Error: it does not fit this document (a `before`
  /// that is not there, an unknown layer, a place beyond the end or taken twice); the message names
  /// the edit, the stroke or layer, and the reason. Time: linear in the changes, and in the strokes
  /// above the lowest one that changes its place.
  Result<void> apply(const Edit& edit);

  /// The stroke, or null.
  [[nodiscard]] StrokePtr find(StrokeId id) const;
  /// Where it stands. Requires that it is there. Linear in the strokes above it.
  [[nodiscard]] StrokePlace place(StrokeId id) const;
  /// The layer of a stroke. Requires that it is there.
  [[nodiscard]] LayerId layer_of(StrokeId id) const;
  /// The lowest first.
  [[nodiscard]] std::span<const Layer> layers() const noexcept { return layers_; }
  /// The layer, or null.
  [[nodiscard]] const Layer* layer(LayerId id) const noexcept;
  [[nodiscard]] std::size_t stroke_count() const noexcept { return strokes_.size(); }
  /// An id that no stroke of this document ever had; the n-th after the next for n > 0. It is taken
  /// once an edit that makes it is applied, and stays taken when that is undone.
  [[nodiscard]] StrokeId new_id(std::uint64_t n = 0) const noexcept { return {last_id_ + 1 + n}; }
  /// Likewise for layers.
  [[nodiscard]] LayerId new_layer_id() const noexcept { return {last_layer_id_ + 1}; }

  /// Counts ids up to these as taken: a document that is read from a file remembers what it had.
  void reserve_ids(StrokeId stroke, LayerId layer) noexcept;

  /// The same strokes, by value, in the same places of the same layers.
  friend bool operator==(const Document& a, const Document& b);

 private:
  struct Entry {
    StrokePtr stroke;
    LayerId layer;
  };
  class Plan;

  std::map<StrokeId, Entry> strokes_;
  std::vector<Layer> layers_;
  std::uint64_t last_id_ = 0;
  std::uint64_t last_layer_id_ = 1;
};

}  // namespace felt
