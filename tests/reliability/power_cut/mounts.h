#pragma once

#include <string>
#include <vector>

namespace felt::power_cut {

/// A file system to try, and how one is made.
struct FileSystem {
  const char* name;
  std::size_t bytes;    ///< of the image; about the smallest that mkfs takes
  const char* make;     ///< command, the image's path follows
  const char* options;  ///< of mount
  const char* mend;     ///< what a starting machine does of its own accord; "" for nothing
};
const std::vector<FileSystem>& file_systems();

/// Why the rig cannot run here; "" where it can: it needs root, FUSE, loop devices, and the right
/// to mount.
std::string why_not();
/// Why this file system cannot be had; "" where it can.
std::string why_not(const FileSystem& system);

/// Everything mounted from now on is seen by this process and its children alone, and goes with
/// the last of them, however it ends; so do loop devices, which clear themselves. `folder`
/// becomes a file system in memory, so the images go too. "" or the reason.
std::string enter_private_mounts(const std::string& folder);

/// What mkfs makes; empty with `error`.
std::vector<char> make_base(const FileSystem& system, const std::string& image, std::string& error);

/// Repairs the image as a starting machine does before it mounts. False: nothing is done then.
bool repair(const FileSystem& system, const std::string& image);

/// An image, mounted by a loop device of its own. Unmounted at the end.
class Mount {
 public:
  /// `error` is empty where it is mounted.
  Mount(const FileSystem& system, const std::string& image, std::string folder, std::string& error);
  ~Mount();
  Mount(const Mount&) = delete;
  Mount& operator=(const Mount&) = delete;

 private:
  std::string folder_;
  bool is_mounted_ = false;
};

}  // namespace felt::power_cut
