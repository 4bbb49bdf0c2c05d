#pragma once

#include <vector>

#include "felt/document/drawing.h"
#include "felt/motion/key_film.h"

/// Key drawings as layers: a layer is a key drawing if it has lines or fills and is not locked. The
/// order of the layers is the order of the key drawings, from the bottom up. Whether a layer is
/// shown does not matter.
namespace felt {

/// Returns true if a layer is a key drawing.
[[nodiscard]] bool is_key_layer(const Layer& layer) noexcept;

/// Returns the layers that are key drawings, in their order.
std::vector<LayerId> key_layers(const Document& document);

/// Returns a layer as a drawing of its own, on this page. The layer is visible and in no group, and
/// its strokes and fills have their ids. Requires that the document has the layer.
Drawing key_drawing(const Document& document, LayerId layer, const Page& page);

/// Returns the number of frames of the film of the key drawings.
[[nodiscard]] std::size_t film_frames(const Document& document);

/// Returns the key drawings with their timings.
std::vector<FilmKey> film_keys(const Document& document, const Page& page);

}  // namespace felt
