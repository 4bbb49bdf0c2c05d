#pragma once

#include <QDateTime>
#include <QLockFile>
#include <QString>
#include <cstddef>
#include <memory>
#include <vector>

#include "desktop/files/drawing_file.h"

namespace felt::desktop {

/// What a recovery folder gives.
struct Recovered {
  Drawing drawing;
  QString name;              ///< what the drawing was called
  QString path;              ///< its file, or ""
  QDateTime when;            ///< of the last stroke
  bool has_changes = false;  ///< there is something that no file has
};

/// A folder that a process left behind, held by this one until it is destroyed.
struct AbandonedFolder {
  QString path;
  std::unique_ptr<QLockFile> lock;

  /// With all that is in it.
  void remove();
};

/// All folders below `root` whose process is gone.
std::vector<AbandonedFolder> find_abandoned(const QString& root);

/// The drawing as it was last: base, edits, and the line in work drawn from its samples. Changes
/// nothing in the folder, so it may be repeated. Whatever a crash cut off at the end of a file is
/// left out. Error: there is no whole base; names the folder. Any thread.
Result<Recovered> recover(const QString& folder);

}  // namespace felt::desktop
