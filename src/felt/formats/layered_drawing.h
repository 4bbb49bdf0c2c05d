#pragma once

#include "felt/io/drawing_view.h"
#include "felt/store/felt_file.h"

namespace felt {

/// Which layers travel, and how.
enum class LayerChoice {
  kAll,      ///< hidden ones as hidden
  kVisible,  ///< what is seen
};

/// A drawing as it travels: each stroke is called after its id, "s12".
LayeredSketch layered_sketch(const StoredDrawing& drawing, LayerChoice choice = LayerChoice::kAll);

/// The same without a copy of the strokes: valid as long as the drawing is, and does not change.
DrawingView view_of(const StoredDrawing& drawing, LayerChoice choice = LayerChoice::kAll);

/// A drawing that arrived. A stroke called "s12" becomes stroke 12, the first of that name; all
/// others get ids above, in their order, so that what layered_sketch() wrote comes back with its
/// ids. Layers are counted from 1; without any there is an empty one. Names are made to fit: a
/// layer without a name, or with one that is no UTF-8 or too long, is called after its place. The
/// sheet is the default one where none came, or one beyond what a sheet may be.
StoredDrawing stored_drawing(LayeredSketch sketch);

/// All strokes of visible layers, in drawing order.
Sketch flat_sketch(const LayeredSketch& sketch);

}  // namespace felt
