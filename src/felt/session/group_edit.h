#pragma once

#include "felt/base/result.h"
#include "felt/document/document.h"
#include "felt/session/event.h"

namespace felt {

/// Returns the effect of kGroup, or of an event that is for a group (LayerEvent::group), as one
/// edit, which is one undo step. The edit is empty if nothing changes.
///
/// Fails if the group or a layer does not exist, if a value is out of range, or if the event cannot
/// be for a group.
Result<Edit> group_edit(const Document& document, const LayerEvent& event);

/// Does the same for kMove, kRaise and kLower of a layer. kRaise and kLower move the layer past its
/// neighbour: within its group, or past the whole group next to it. Requires that the layer exists.
Result<Edit> layer_move(const Document& document, const LayerEvent& event);

}  // namespace felt
