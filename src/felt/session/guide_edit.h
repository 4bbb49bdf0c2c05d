#pragma once

#include "felt/base/result.h"
#include "felt/document/document.h"
#include "felt/session/event.h"

namespace felt {

/// Returns the whole effect of an event on the guides of a document as one edit, which is one undo
/// step. The edit is empty if nothing changes; for kUnlink it is always empty, because that depends
/// on the selection (unlink_edit).
///
/// Fails if the guide to change or remove does not exist; if check_drawing_guide() refuses the new
/// guide, or it traces a stroke that does not exist; or if the drawing has too many guides
/// (kMaxDrawingGuides).
Result<Edit> guide_edit(const Document& document, const GuidesEvent& event);

}  // namespace felt
