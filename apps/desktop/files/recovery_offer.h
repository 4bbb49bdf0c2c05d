#pragma once

#include <QDateTime>
#include <QString>
#include <optional>
#include <vector>

#include "desktop/files/drawing_file.h"
#include "felt/autosave/recovery.h"

namespace felt::desktop {

/// The user's saved file, to compare it with the recovered drawing.
struct SavedDrawing {
  Drawing drawing;
  QDateTime when;  ///< modification time of the file
};

/// A drawing that a crash left behind.
struct RecoveryOffer {
  AbandonedAutosave store;
  Recovered recovered;
  std::optional<SavedDrawing> saved;  ///< nullopt if the drawing has no file, or if the file cannot
                                      ///< be read
};

/// Reads the autosaves of dead processes, and the saved files. Removes an autosave if it is empty
/// or if the file contains the same drawing. Keeps an autosave that cannot be read, because a newer
/// version of the program may be able to read it. Safe to call from any thread.
std::vector<RecoveryOffer> read_offers(std::vector<AbandonedAutosave> stores);

}  // namespace felt::desktop
