#pragma once

#include <QString>
#include <span>
#include <string>

#include "desktop/engine/studio.h"
#include "felt/io/import.h"

namespace felt::desktop {

/// Adds the strokes of another drawing as one step of undo, together with their media. The texts
/// of the media are in `materials`. If a medium has other figures in this drawing, it stays as it
/// is, and `report` names it. Returns false if the session refuses the strokes (Studio::import). A
/// recording stores `from`, the name of their source.
bool add_strokes(Studio& studio, const QString& from, std::span<const StrokePtr> strokes,
                 std::span<const std::string> materials, ImportReport& report);

}  // namespace felt::desktop
