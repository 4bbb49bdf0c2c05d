#pragma once

#include <sys/types.h>

#include <string>
#include <string_view>

/// The steps that a careful write is made of (AtomicFile). Linux and POSIX only; of this layer
/// alone. All of them work on paths whose links are resolved. False: errno says why.
namespace felt::file_steps {

/// The file that a path means once links are followed, also where the last one leads to nothing
/// yet; the path itself where there is no link.
std::string resolved(const std::string& path);
std::string folder_of(const std::string& path);

/// A hidden name beside `target` that no other file has at the moment: ".NAME.PID-N.ENDING".
std::string name_beside(const std::string& target, const char* ending);

/// open(2), again where a signal comes in between, as it may on network file systems.
int open_file(const std::string& path, int flags, mode_t permissions = 0) noexcept;
/// write(2) until all is out.
bool write_all(int fd, std::string_view bytes) noexcept;

/// A file in `folder` without a name, which vanishes with the process; -1 where the system has no
/// such files, or no way to name them later. Its permissions: these less the umask.
int open_unnamed(const std::string& folder, mode_t permissions);
/// A new file under a name of its own beside `target`, which it returns; -1 with errno.
int open_named(const std::string& target, mode_t permissions, std::string& name);
/// Gives a file without a name one beside `target`; "" with errno.
std::string give_name(int fd, const std::string& target);

/// The new file gets the old one's owner, group, permissions and extended attributes, as far as
/// the system lets us. Nothing here can fail a save: ink is worth more than an attribute.
void copy_attributes(int from, int to) noexcept;

/// Whether the file holds exactly these bytes, opened anew and, where the system can, read from
/// the disk and not from memory. False with errno 0: it holds others.
bool holds(const std::string& path, std::string_view bytes) noexcept;

/// A second name for the file at `path`, beside it, or a durable copy where the file system has no
/// second names. The name; "" with errno.
std::string keep_beside(const std::string& path);

/// True where nothing can be done: some file systems cannot sync a folder and say EINVAL, and a
/// folder that may be written but not read cannot be opened.
bool sync_folder(const std::string& folder) noexcept;

/// Removes what processes that are gone left beside `target`; the second names of files that they
/// were about to replace only with `old_ones`, for whoever knows that the file there is whole. Who
/// still works holds a lock (hold_lock) on its file, and keeps it.
void remove_leftovers(const std::string& target, bool old_ones);
/// "I am alive": for as long as the file is open. Nothing happens where there are no locks.
void hold_lock(int fd) noexcept;

}  // namespace felt::file_steps
