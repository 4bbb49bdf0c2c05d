#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "felt/document/edit.h"

namespace felt {

struct SceneLayer;
struct SceneStroke;

/// Up to kMost strokes of a layer in drawing order; a layer is a list of these.
struct OrderBlock {
  static constexpr std::size_t kMost = 512;
  std::vector<SceneStroke*> strokes;
  std::size_t first = 0;     ///< place of its lowest stroke in the layer
  bool is_numbered = false;  ///< its strokes know their slots
};

/// Strokes of about the same size whose middles lie in the same square of the sheet.
struct StrokeCell {
  std::vector<SceneStroke*> strokes;
};

/// A stroke of a display: what it looks like, where it stands, where to find it again.
struct SceneStroke {
  StrokeId id;
  StrokePtr stroke;
  Rect box;  ///< around its ink
  SceneLayer* layer = nullptr;
  bool is_previewed = false;  ///< as a preview shows it, not as the document has it
  // Of StrokeOrder.
  OrderBlock* block = nullptr;
  std::size_t slot = 0;
  // Of StrokeGrid.
  StrokeCell* cell = nullptr;
  std::size_t cell_slot = 0;

  /// Its place in the drawing order of its layer, 0 is the lowest.
  [[nodiscard]] std::size_t rank() const noexcept { return block->first + slot; }
};

}  // namespace felt
