#pragma once

#include "felt/base/result.h"
#include "felt/document/document.h"
#include "felt/session/event.h"

namespace felt {

/// Returns true if tools and the user may change the layer, that is, if it is visible and not
/// locked.
inline bool is_open(const Layer& layer) noexcept {
  return layer.visible && !layer.locked;
}

/// Returns the highest open layer, which receives new ink if the current layer cannot; an empty id
/// if no layer is open.
LayerId highest_open_layer(const Document& document) noexcept;

/// Returns the whole effect of a layer event on a document as one edit, which is one undo step. The
/// edit is empty if nothing changes; for kUse it is always empty. If no open layer would remain,
/// the edit also adds an open layer on top, because ink must never go to a layer that the user
/// cannot see.
///
/// Fails if the layer does not exist, or if the event is kUse and the layer is not open. The
/// message names the layer and the reason.
Result<Edit> layer_edit(const Document& document, const LayerEvent& event, LayerId in_use);

/// Returns an edit that adds an open layer on top.
Edit add_layer_on_top(const Document& document);

}  // namespace felt
