#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "felt/document/edit.h"

namespace felt {

struct SceneLayer;
struct SceneStroke;

/// Up to kMax strokes of a layer in drawing order; a layer is a list of such blocks.
struct OrderBlock {
  static constexpr std::size_t kMax = 512;
  std::vector<SceneStroke*> strokes;
  std::size_t first = 0;     ///< position of the block's lowest stroke in the layer
  bool is_numbered = false;  ///< the `slot` of each of its strokes is up to date
};

/// Strokes of about the same size with their middles in the same square of the page.
struct StrokeCell {
  std::vector<SceneStroke*> strokes;
};

/// A stroke of an InkScene: its shape, its position in the drawing order, and its entries in the
/// indexes.
struct SceneStroke {
  StrokeId id;
  StrokePtr stroke;
  Rect box;  ///< bounds of its ink
  SceneLayer* layer = nullptr;
  bool is_previewed = false;  ///< shown as in a preview, not as in the document
  // Set and used by StrokeOrder.
  OrderBlock* block = nullptr;
  std::size_t slot = 0;
  // Set and used by StrokeGrid.
  StrokeCell* cell = nullptr;
  std::size_t cell_slot = 0;

  /// Returns the stroke's position in the drawing order of its layer; 0 is the lowest.
  [[nodiscard]] std::size_t rank() const noexcept { return block->first + slot; }
};

}  // namespace felt
