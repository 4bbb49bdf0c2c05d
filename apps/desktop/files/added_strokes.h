#pragma once

#include <QString>
#include <span>
#include <string>

#include "desktop/engine/studio.h"
#include "felt/io/import.h"

namespace felt::desktop {

/// Adds strokes of another drawing as one step of undo, with their media, whose texts are in
/// `materials`. A medium that has other figures here stays as it is; `report` names it. Returns
/// false if the session refuses the strokes (Studio::import). `from` is the name of their source in
/// a recording.
bool add_strokes(Studio& studio, const QString& from, std::span<const StrokePtr> strokes,
                 std::span<const std::string> materials, ImportReport& report);

}  // namespace felt::desktop
