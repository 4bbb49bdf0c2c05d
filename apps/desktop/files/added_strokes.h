#pragma once

#include <QString>
#include <memory>

#include "desktop/engine/studio.h"
#include "felt/document/drawing.h"
#include "felt/io/import.h"

namespace felt::desktop {

/// What becomes of a name that a stroke of the drawing has already: it is reported as left out, or
/// not, because the strokes are copies of those of the drawing.
enum class UsedNames { kReported, kExpected };

/// Adds the visible strokes and fills of another drawing, moved by `by_mm`, as one step of undo,
/// together with their media. If the studio's drawing already has a medium with the same name but
/// other values, that medium stays as it is. `names` are the names of the strokes of the studio's
/// drawing (Drawing::names); it gets those of the added strokes. `report` gets what was changed or
/// left out, each kind once with its number. `from` is the name of the strokes' source; a recording
/// stores it. Returns false if the session refuses the strokes (Studio::import).
bool add_drawing(Studio& studio, const QString& from, const Drawing& added, Vec by_mm,
                 UsedNames used, std::shared_ptr<const StrokeNames>& names, ImportReport& report);

}  // namespace felt::desktop
