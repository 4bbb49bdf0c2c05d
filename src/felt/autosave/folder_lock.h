#pragma once

#include <string>
#include <vector>

#include "felt/base/result.h"

namespace felt {

/// A folder belongs to one process at a time. The file `lock` in it is locked by flock, which ends
/// with the process however it ends, and says who holds it: process number, start of the process,
/// boot of the machine. Where the file system knows no locks, these three decide: who holds a lock
/// and lives no more, or lived before the machine was started, holds it no more.
class FolderLock {
 public:
  /// Error: somebody else has it, or this process in another place (kUnsupported: it is not ours
  /// to have now), the folder is not there, or the system refuses (kIo). Names the folder.
  static Result<FolderLock> take(const std::string& folder);

  FolderLock(FolderLock&& other) noexcept;
  FolderLock& operator=(FolderLock&& other) noexcept;
  /// Lets it go. The file stays.
  ~FolderLock();

 private:
  FolderLock() = default;
  int fd_ = -1;
};

/// Makes a folder, and those above it, that only this user may look into (mode 0700). Error: it
/// is no folder, belongs to somebody else, is open to others, or the system refuses; names it.
Result<void> make_private_folder(const std::string& path);

/// Where working stores may be, the best place first: feltline/working below $XDG_STATE_HOME
/// (~/.local/state), $XDG_CACHE_HOME (~/.cache), then $XDG_RUNTIME_DIR or a folder of this user's
/// in the folder for temporary files. Nothing is made. A variable that is no absolute path counts
/// as not set.
std::vector<std::string> working_roots();

}  // namespace felt
