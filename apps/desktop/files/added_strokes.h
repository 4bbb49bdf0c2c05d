#pragma once

#include <QString>
#include <span>
#include <string>

#include "desktop/engine/studio.h"
#include "felt/document/visible_strokes.h"
#include "felt/io/import.h"

namespace felt::desktop {

/// Adds the strokes and fills of another drawing as one step of undo, together with their media.
/// `materials` contains the texts of the media. If the studio's drawing already has a medium with
/// the same name but other values, that medium stays as it is, and `report` names it. `from` is the
/// name of the strokes' source; a recording stores it. Returns false if the session refuses the
/// strokes (Studio::import).
bool add_strokes(Studio& studio, const QString& from, const VisibleInk& ink,
                 std::span<const std::string> materials, ImportReport& report);

/// Reports the number of pictures of layers, which add_strokes() does not add.
void note_pictures(const Document& document, ImportReport& report);

}  // namespace felt::desktop
