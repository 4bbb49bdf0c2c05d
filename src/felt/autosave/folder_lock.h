#pragma once

#include <string>
#include <vector>

#include "felt/base/result.h"

namespace felt {

/// A folder that belongs to one process at a time: flock on the file `lock` in it, which ends with
/// the process however it ends, so a lock held by a dead process is stale. File systems without
/// locks cannot hold an AutosaveDatabase either, because SQLite locks its file, too.
///
/// SQLite's exclusive lock of the database cannot take its place:
///   - the folder is locked when the database has not got its name yet, and while there is only a
///     copy that recovery reads, so that nobody takes it for what a dead process left;
///   - a recovery holds the lock for minutes and must not write, but SQLite recovers the WAL when
///   it
///     locks a database, and refuses to open a damaged one;
///   - it is a POSIX lock, which is lost when its process reads the file by other means (to copy
///     it): then a second process opens the database and deletes the WAL.
class FolderLock {
 public:
  /// Locks a folder. Fails if another process has it, or another object of this process
  /// (kUnsupported), if there is no such folder (kNotFound), or if the system refuses (kIo). Names
  /// the folder.
  static Result<FolderLock> take(const std::string& folder);

  FolderLock(FolderLock&& other) noexcept;
  FolderLock& operator=(FolderLock&& other) noexcept;
  /// Unlocks it. The file stays.
  ~FolderLock();

 private:
  FolderLock() = default;
  int fd_ = -1;
};

/// Makes a folder, and those above it, that only this user can read (mode 0700). Fails if it is no
/// folder, belongs to another user, stays open to others, or the system refuses; names it.
Result<void> make_private_folder(const std::string& path);

/// Returns the folders for autosaves, the preferred one first: feltline/working below
/// $XDG_STATE_HOME
/// (~/.local/state), $XDG_CACHE_HOME (~/.cache), then $XDG_RUNTIME_DIR or a folder of this user's
/// in the folder for temporary files. Makes none of them. A variable that is no absolute path
/// counts as not set.
std::vector<std::string> autosave_roots();

}  // namespace felt
