#pragma once

#include <string>
#include <vector>

#include "felt/base/result.h"

namespace felt {

/// Locks a folder for one process at a time, by flock on the file `lock` in the folder. The system
/// releases the lock when the process ends for any reason. A file system without locks cannot hold
/// an AutosaveDatabase either, because SQLite locks its file, too.
///
/// SQLite's exclusive lock of the database is not sufficient:
///   - the folder must also be locked before the database has its final name, and while the folder
///     holds only a copy for recovery. Otherwise another process could mistake the folder for an
///     abandoned autosave;
///   - a recovery holds the lock for minutes and must not write to the database. But SQLite can
///     lock a database only after opening it, and when it opens a database, it merges the WAL into
///     it. Besides, SQLite does not open a damaged database;
///   - SQLite's lock is a POSIX lock. It is lost if the process that holds it also opens and closes
///     the file directly (to copy it). After that, a second process could open the database and
///     delete the WAL.
class FolderLock {
 public:
  /// Locks a folder. Fails if another process or another object of this process has locked it
  /// (kUnsupported), if the folder does not exist (kNotFound), or if the system refuses (kIo). The
  /// message names the folder.
  static Result<FolderLock> take(const std::string& folder);

  FolderLock(FolderLock&& other) noexcept;
  FolderLock& operator=(FolderLock&& other) noexcept;
  /// Unlocks the folder. The file `lock` stays.
  ~FolderLock();

 private:
  FolderLock() = default;
  int fd_ = -1;
};

/// Creates a folder that only this user can read (mode 0700), and its parent folders. Fails if the
/// path is not a folder, belongs to another user, stays accessible to other users, or the system
/// refuses. The message names the folder.
Result<void> make_private_folder(const std::string& path);

/// Returns the folders for autosaves, the preferred one first: feltline/working in $XDG_STATE_HOME
/// (default: ~/.local/state), in $XDG_CACHE_HOME (default: ~/.cache) and in $XDG_RUNTIME_DIR (if
/// set), and last a folder of this user in the folder for temporary files. Does not create them. A
/// variable that is not an absolute path counts as not set.
std::vector<std::string> autosave_roots();

}  // namespace felt
