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
  std::string name;               ///< what the drawing was called
  std::string path;               ///< the user's file, or ""
  bool has_changes = false;       ///< there are unsaved changes
  std::int64_t changed_at_s = 0;  ///< when the autosave was last written, seconds since 1970
  std::uint64_t edits = 0;        ///< applied since the base
  /// Time of the newest sample in the drawing, on the session's clock; -1 if no gesture was in
  /// progress.
  std::int64_t last_sample_ns = -1;
  /// What could not be read, and what happened to it, a sentence each; usually none.
  std::vector<std::string> problems;
};

/// The autosave of a dead process. It stays locked while this object lives.
struct AbandonedAutosave {
  std::string folder;
  FolderLock lock;
  std::int64_t changed_at_s = 0;  ///< when it was last written, seconds since 1970

  /// Deletes it: the user discarded the drawing, or saved it.
  Result<void> remove() &&;
};

/// Returns all autosaves below these folders whose process is gone, the newest first. Folders that
/// do not exist have none. Deletes what a killed start or recovery left that holds no drawing.
std::vector<AbandonedAutosave> find_abandoned_autosaves(const std::vector<std::string>& roots);

/// Returns the drawing as it was last: base, edits, and the unfinished gesture drawn from its
/// samples. Works on a copy that it makes beside the folder (or in the folder for temporary files,
/// if that fails) and deletes. The autosave itself is only read, so recovery can be repeated
/// whatever happens.
///
/// From a damaged autosave it returns what is intact, and reports what is not: rows with a wrong
/// checksum are skipped, an incomplete base is replaced by the user's file, and the strokes of
/// edits that do not fit any more are kept. Fails if nothing can be read; names the folder. Any
/// thread.
Result<Recovered> recover_autosave(const std::string& folder);

}  // namespace felt
