#pragma once

#include <optional>
#include <string>

namespace felt {

/// The regular files that this process has read, so that no output replaces one of them. A file is
/// known by its device and inode: its links and other spellings of its path are the same file. All
/// functions may be called from any thread.

/// Starts the list. Before this call nothing is listed, so that a program that saves the drawing
/// that it has read, such as the desktop program, is not affected.
void protect_input_files();

/// Adds an open file to the list under the name that messages use. Does nothing for pipes, devices
/// and folders, and before protect_input_files().
void note_input_file(int fd, const std::string& name);

/// Returns the name under which the file at `path` was read, or nullopt if it was not read or does
/// not exist.
[[nodiscard]] std::optional<std::string> input_file_at(const std::string& path);

}  // namespace felt
