#pragma once

#include "felt/document/document.h"

namespace felt::desktop {

/// The colours of the key drawings before and after the current one. Other colours of the same
/// palette mark what a tool does (docs/guide/README.md).
inline constexpr Rgba kOnionBefore{204, 121, 167, 255}, kOnionAfter{0, 158, 115, 255};

/// Returns a drawing of the key drawings (felt/motion/key_layers.h) before and after the layer
/// `current`, translucent, each in its colour. `current` need not be a key drawing itself. Requires
/// that the document has it.
Document onion_skin(const Document& document, LayerId current);

}  // namespace felt::desktop
