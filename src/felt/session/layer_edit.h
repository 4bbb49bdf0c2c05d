#pragma once

#include "felt/base/result.h"
#include "felt/document/document.h"
#include "felt/session/event.h"

namespace felt {

/// True when tools and people may work on it: visible and not locked.
inline bool is_open(const Layer& layer) noexcept {
  return layer.visible && !layer.locked;
}

/// The layer for new ink when another is not to be had: the highest open one; none where there is
/// none.
LayerId highest_open_layer(const Document& document) noexcept;

/// What a layer event does to a document, all of it, as one step of undo; empty where it changes
/// nothing, as kUse never does. Where no open layer would be left, the edit adds one on top: ink
/// must never go where nobody sees it.
///
/// Error: no such layer; kUse of one that is not open. The message names the layer and the reason.
Result<Edit> layer_edit(const Document& document, const LayerEvent& event, LayerId in_use);

/// Adds an open layer on top.
Edit add_layer_on_top(const Document& document);

}  // namespace felt
