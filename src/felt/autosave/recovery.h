#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "felt/autosave/folder_lock.h"
#include "felt/base/result.h"
#include "felt/store/felt_file.h"

namespace felt {

/// What a working store gives.
struct RecoveredDrawing {
  StoredDrawing drawing;
  std::string name;               ///< what the drawing was called
  std::string path;               ///< the person's file, or ""
  bool has_changes = false;       ///< there is something that no file of the person's has
  std::int64_t changed_at_s = 0;  ///< when the store was written last, seconds since 1970
  std::uint64_t edits = 0;        ///< that were carried out since the base
  /// Of the newest sample that is in the drawing, on the session's clock; -1 where no gesture was
  /// in work.
  std::int64_t last_sample_ns = -1;
  /// What could not be read, and what became of it, a sentence each; none as a rule.
  std::vector<std::string> problems;
};

/// A store that a dead process left behind. Nobody else can have it as long as this lives.
struct AbandonedStore {
  std::string folder;
  FolderLock lock;
  std::int64_t changed_at_s = 0;  ///< likewise

  /// Deletes it with all that is in it: a person said so, or saved what was in it.
  Result<void> remove() &&;
};

/// All stores below these folders whose process is gone, the newest first. Folders that are not
/// there hold none. Takes away what a killed start or recovery left behind that holds no drawing.
std::vector<AbandonedStore> find_abandoned(const std::vector<std::string>& roots);

/// The drawing as it was last: base, edits, and the gesture in work drawn from its samples. Works
/// on a copy that it makes beside the folder (where that fails, in the folder for temporary files)
/// and deletes: the store itself is only read, so that it may be repeated after whatever happens.
///
/// A damaged store gives what is intact, and says what is not: rows whose checksum is wrong are
/// left out, a base that never came to be whole is replaced by the person's file, edits that no
/// longer fit give their strokes all the same. Error: there is nothing to be had; names the folder.
/// Any thread.
Result<RecoveredDrawing> recover_store(const std::string& folder);

}  // namespace felt
