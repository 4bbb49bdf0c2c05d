#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "felt/autosave/folder_lock.h"
#include "felt/base/result.h"
#include "felt/store/felt_file.h"

namespace felt {

/// A drawing recovered from an autosave.
struct Recovered {
  Drawing drawing;
  std::string name;               ///< the drawing's name, as shown to the user
  std::string path;               ///< path of the user's file; "" if the drawing has no file
  bool has_changes = false;       ///< true if the drawing has unsaved changes
  std::int64_t changed_at_s = 0;  ///< when the autosave was last written, seconds since 1970
  std::uint64_t edits = 0;        ///< number of edits that were applied to the base
  /// Time of the newest sample in the drawing, on the session's clock; -1 if no gesture was in
  /// progress.
  std::int64_t last_sample_ns = -1;
  /// One sentence for each part that could not be read. The sentence also says how the part was
  /// handled. The list is usually empty.
  std::vector<std::string> problems;
};

/// The autosave of a dead process. Its folder stays locked while this object exists.
struct AbandonedAutosave {
  std::string folder;
  FolderLock lock;
  std::int64_t changed_at_s = 0;  ///< when it was last written, seconds since 1970

  /// Deletes the autosave. Call after the user has discarded or saved the drawing.
  Result<void> remove() &&;
};

/// Returns all autosaves below these folders that belong to ended processes, the newest first.
/// Ignores roots that do not exist. Also deletes folders without a drawing. Such a folder remains
/// if the program was killed during its start or during a recovery.
std::vector<AbandonedAutosave> find_abandoned_autosaves(const std::vector<std::string>& roots);

/// Returns the last state of the drawing: the base with all edits applied, and the unfinished
/// gesture, drawn again from its samples. Works on a copy of the database and deletes the copy
/// afterwards. Makes the copy beside the autosave's folder or, if that fails, in the folder for
/// temporary files. The autosave itself is only read, so recovery can always be repeated.
///
/// From a damaged autosave it returns the intact parts, and reports the other parts in `problems`.
/// It skips rows with a wrong checksum, replaces an incomplete base with the user's file, and keeps
/// the strokes of edits that do not fit the document any more. Fails if nothing can be read; the
/// message names the folder. Safe to call from any thread.
Result<Recovered> recover_autosave(const std::string& folder);

}  // namespace felt
