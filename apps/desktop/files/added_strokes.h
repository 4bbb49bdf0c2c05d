#pragma once

#include <QString>
#include <string>
#include <vector>

#include "desktop/engine/studio.h"
#include "felt/io/import.h"
#include "felt/stroke/sketch.h"

namespace felt::desktop {

/// Strokes of another drawing, and the texts of the materials that it brings along.
struct ForeignStrokes {
  Sketch strokes;
  std::vector<std::string> materials;
};

/// Adds them as one step of undo, with their media. A medium that is another one here stays as it
/// is: `report` names it. False: the session refuses the strokes (Studio::import). `from` is what a
/// recording calls their source.
bool add_strokes(Studio& studio, const QString& from, const ForeignStrokes& foreign,
                 ImportReport& report);

}  // namespace felt::desktop
