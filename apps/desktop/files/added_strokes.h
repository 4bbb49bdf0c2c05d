#pragma once

#include <QString>
#include <span>
#include <string>

#include "desktop/engine/studio.h"
#include "felt/io/import.h"

namespace felt::desktop {

/// Adds strokes of another drawing as one step of undo, with their media, whose texts `materials`
/// holds. A medium that is another one here stays as it is: `report` names it. Returns false if the
/// session refuses the strokes (Studio::import). `from` is what a recording calls their source.
bool add_strokes(Studio& studio, const QString& from, std::span<const StrokePtr> strokes,
                 std::span<const std::string> materials, ImportReport& report);

}  // namespace felt::desktop
