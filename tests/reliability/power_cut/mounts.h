#pragma once

#include <string>
#include <vector>

namespace felt::power_cut {

/// A type of file system to test, with the commands to create and repair one.
struct FileSystem {
  const char* name;
  std::size_t bytes;    ///< size of the image, near the minimum of mkfs
  const char* make;     ///< mkfs command; the path of the image is appended
  const char* options;  ///< mount options
  const char* mend;     ///< repair command that runs at each system start; "" if none does
};
const std::vector<FileSystem>& file_systems();

/// Returns the reason why the test cannot run on this machine, or "" if it can. It needs root,
/// FUSE, loop devices, and the right to mount.
std::string why_not();
/// Returns the reason why this file system cannot be used here, or "" if it can.
std::string why_not(const FileSystem& system);

/// Makes all later mounts private to this process and its children. They disappear with the last of
/// these processes, however it ends, and so do the loop devices. Mounts a file system in memory on
/// `folder`, so that the images disappear too. Returns "" or the error.
std::string enter_private_mounts(const std::string& folder);

/// Returns the content of a new file system. If mkfs fails, returns an empty vector and sets
/// `error`.
std::vector<char> make_base(const FileSystem& system, const std::string& image, std::string& error);

/// Repairs the image as a system start does before it mounts. Returns false if no repair runs at
/// system start.
bool repair(const FileSystem& system, const std::string& image);

/// A mounted image, with its own loop device. The destructor unmounts it.
class Mount {
 public:
  /// Mounts the image on `folder`. Sets `error`, which is empty on success.
  Mount(const FileSystem& system, const std::string& image, std::string folder, std::string& error);
  ~Mount();
  Mount(const Mount&) = delete;
  Mount& operator=(const Mount&) = delete;

 private:
  std::string folder_;
  bool is_mounted_ = false;
};

}  // namespace felt::power_cut
