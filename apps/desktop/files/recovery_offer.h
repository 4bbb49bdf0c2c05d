#pragma once

#include <QDateTime>
#include <QString>
#include <optional>
#include <vector>

#include "desktop/files/drawing_file.h"
#include "felt/autosave/recovery.h"

namespace felt::desktop {

/// What is in the person's file, beside what was recovered.
struct SavedDrawing {
  Drawing drawing;
  QDateTime when;  ///< of the file
};

/// A drawing that a crash left behind.
struct RecoveryOffer {
  AbandonedAutosave store;
  Recovered recovered;
  std::optional<SavedDrawing> saved;  ///< none: it has no file, or that cannot be read
};

/// Reads what dead processes left, and the files beside it. Stores whose drawing is in its file, or
/// that hold nothing, are removed; one that cannot be read stays where it is: a newer program may
/// know more. Any thread.
std::vector<RecoveryOffer> read_offers(std::vector<AbandonedAutosave> stores);

}  // namespace felt::desktop
