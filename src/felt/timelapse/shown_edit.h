#pragma once

#include <optional>

#include "felt/document/edit.h"
#include "felt/session/session.h"

namespace felt {

/// Returns an edit of the session's document that shows the gesture in progress: the tool's
/// preview, and the wet ink as strokes on top of the current layer. Returns nullopt if there is
/// neither. The preview of a hovering pen is not included.
std::optional<Edit> shown_edit(const Session& session);

/// Returns an edit in which all pictures that exported files do not show are left out of the states
/// of layers. Pictures of the drawing's films are exported pictures.
Edit with_exported_pictures(Edit edit);

}  // namespace felt
