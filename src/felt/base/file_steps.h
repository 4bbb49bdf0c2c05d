#pragma once

#include <sys/types.h>

#include <string>
#include <string_view>

/// The steps of a safe write (AtomicFile). Supports Linux and POSIX only. Private to this layer.
/// Except for resolved(), all functions expect paths that contain no symbolic links. If a function
/// returns false, errno contains the reason.
namespace felt::file_steps {

/// Returns the path with all links followed, even if the last link points to a file that does not
/// exist yet. Returns the path itself if it has no links.
std::string resolved(const std::string& path);
std::string folder_of(const std::string& path);

/// Returns a hidden name beside `target` that this process has not used before:
/// ".NAME.PID-N" + ending.
std::string name_beside(const std::string& target, const char* ending);

/// Calls open(2). Repeats the call if a signal interrupts it, which can happen on network file
/// systems.
int open_file(const std::string& path, int flags, mode_t permissions = 0) noexcept;
/// Calls write(2) until everything is written.
bool write_all(int fd, std::string_view bytes) noexcept;

/// Opens a file without a name in `folder`. The system deletes the file when the process ends,
/// unless it was given a name. Returns -1 if the system does not support such files, or cannot give
/// them a name later. The umask applies to `permissions`.
int open_unnamed(const std::string& folder, mode_t permissions);
/// Creates a file with a new hidden name beside `target` and stores the name in `name`. Returns the
/// descriptor, or -1 with errno.
int open_named(const std::string& target, mode_t permissions, std::string& name);
/// Gives an unnamed file a hidden name beside `target`. Returns the name, or "" with errno.
std::string give_name(int fd, const std::string& target);

/// Copies owner, group, permissions and extended attributes from the old file to the new one, as
/// far as the system allows. Errors are ignored, because a drawing is worth more than an attribute.
void copy_attributes(int from, int to) noexcept;

/// Returns true if the file contains exactly these bytes. Reopens the file, and reads from the disk
/// instead of the page cache if the system allows it. If the result is false and errno is 0, the
/// content differs.
bool holds(const std::string& path, std::string_view bytes) noexcept;

/// Gives the file at `path` a second, hidden name (a hard link), or makes a durable copy if the
/// file system has no hard links. Returns the name, or "" with errno.
std::string keep_beside(const std::string& path);

/// Writes a folder to the disk (fsync). Also returns true in two cases in which a folder cannot be
/// synced: if the file system does not support it (EINVAL), and if the folder cannot be opened
/// because read permission is missing.
bool sync_folder(const std::string& folder) noexcept;

/// Removes the files that dead processes left beside `target`. Files that a running process still
/// uses are locked (hold_lock) and stay. The second names of old files (keep_beside) are removed
/// only if `old_ones` is true. Pass true only if `target` is known to be complete.
void remove_leftovers(const std::string& target, bool old_ones);
/// Locks the file for as long as it is open, to show other processes that it is in use. Does
/// nothing if the file system has no locks.
void hold_lock(int fd) noexcept;

}  // namespace felt::file_steps
