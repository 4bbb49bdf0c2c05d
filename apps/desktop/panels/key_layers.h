#pragma once

#include <optional>
#include <vector>

#include "felt/document/drawing.h"

/// Key drawings as layers: a layer is a key drawing if it has lines or fills and is not locked. The
/// order of the layers is the order of the key drawings, from the bottom up. Whether a layer is
/// shown does not matter.
namespace felt::desktop {

/// Returns the layers that are key drawings, in their order.
std::vector<LayerId> key_layers(const Document& document);

/// Returns a layer as a drawing of its own, on this page. The layer is visible and in no group.
/// Requires that the document has the layer.
Drawing key_drawing(const Document& document, LayerId layer, const Page& page);

/// Returns the key drawings as drawings.
std::vector<Drawing> key_drawings(const Document& document, const Page& page);

/// The colours of the key drawings before and after the current one. Other colours of the same
/// palette mark what a tool does (docs/guide/README.md).
inline constexpr Rgba kOnionBefore{204, 121, 167, 255}, kOnionAfter{0, 158, 115, 255};

/// Returns a drawing of the key drawings before and after the layer `current`, translucent, each in
/// its colour. `current` need not be a key drawing itself. Requires that the document has it.
Document onion_skin(const Document& document, LayerId current);

}  // namespace felt::desktop
