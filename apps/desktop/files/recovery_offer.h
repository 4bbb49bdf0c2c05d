#pragma once

#include <QDateTime>
#include <QString>
#include <optional>
#include <vector>

#include "desktop/files/drawing_file.h"
#include "felt/autosave/recovery.h"

namespace felt::desktop {

/// The user's saved file, for comparison with the recovered drawing.
struct SavedDrawing {
  Drawing drawing;
  QDateTime when;  ///< of the file
};

/// A drawing that a crash left behind.
struct RecoveryOffer {
  AbandonedAutosave store;
  Recovered recovered;
  std::optional<SavedDrawing> saved;  ///< none: it has no file, or the file cannot be read
};

/// Reads the autosaves of dead processes, and the saved files. Removes autosaves that are empty or
/// whose drawing is in its file. One that cannot be read stays where it is, because a newer program
/// may be able to read it. Safe to call from any thread.
std::vector<RecoveryOffer> read_offers(std::vector<AbandonedAutosave> stores);

}  // namespace felt::desktop
