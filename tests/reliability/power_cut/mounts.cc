#include "tests/reliability/power_cut/mounts.h"

#include <errno.h>
#include <fcntl.h>
#include <linux/loop.h>
#include <sched.h>
#include <string.h>
#include <sys/ioctl.h>
#include <sys/mount.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>

namespace felt::power_cut {
namespace {

constexpr std::size_t kMiB = std::size_t{1} << 20;

std::string reason() {
  return strerror(errno);
}

bool has_command(const std::string& name) {
  return std::system(("command -v " + name + " >/dev/null 2>&1").c_str()) == 0;
}

/// Attaches a loop device to the image. The kernel detaches it once no process has it open. Returns
/// its descriptor, or -1 and sets errno.
int attach(const std::string& image, std::string& device) {
  const int control = ::open("/dev/loop-control", O_RDWR | O_CLOEXEC);
  const int file = ::open(image.c_str(), O_RDWR | O_CLOEXEC);
  int loop = -1;
  // Another process may take the free device before this one attaches it, so try again.
  for (int attempt = 0; control >= 0 && file >= 0 && loop < 0 && attempt < 64; ++attempt) {
    const int number = ::ioctl(control, LOOP_CTL_GET_FREE);
    if (number < 0) break;
    device = "/dev/loop" + std::to_string(number);
    loop = ::open(device.c_str(), O_RDWR | O_CLOEXEC);
    if (loop < 0) break;
    struct loop_config config = {};
    config.fd = static_cast<__u32>(file);
    config.info.lo_flags = LO_FLAGS_AUTOCLEAR;
    if (::ioctl(loop, LOOP_CONFIGURE, &config) == 0) break;
    const int why = errno;
    ::close(loop);
    loop = -1;
    errno = why;
    if (why != EBUSY) break;
  }
  const int why = errno;
  if (control >= 0) ::close(control);
  if (file >= 0) ::close(file);
  errno = why;
  return loop;
}

}  // namespace

const std::vector<FileSystem>& file_systems() {
  static const std::vector<FileSystem> all = {
      {"ext4", 48 * kMiB, "mkfs.ext4 -q -F", "commit=5", "e2fsck -fy"},
      {"xfs", 300 * kMiB, "mkfs.xfs -q -f", "nouuid", ""},
      {"btrfs", 128 * kMiB, "mkfs.btrfs -q -f", "", ""},
  };
  return all;
}

std::string why_not() {
  if (::geteuid() != 0) return "this is not root, and only root may mount";
  for (const char* device : {"/dev/fuse", "/dev/loop-control"}) {
    const int fd = ::open(device, O_RDWR | O_CLOEXEC);
    if (fd < 0) return std::string(device) + ": " + reason();
    ::close(fd);
  }
  return "";
}

std::string why_not(const FileSystem& system) {
  const std::string command = std::string("mkfs.") + system.name;
  if (!has_command(command)) return command + " is not installed";
  std::ifstream known("/proc/filesystems");
  const std::string text{std::istreambuf_iterator<char>(known), {}};
  if (text.find(std::string("\t") + system.name + "\n") != std::string::npos) return "";
  // The file system may be a kernel module that the first mount would load.
  return has_command("modprobe") &&
                 std::system((std::string("modprobe ") + system.name + " 2>/dev/null").c_str()) == 0
             ? ""
             : std::string("the kernel has no ") + system.name;
}

std::string enter_private_mounts(const std::string& folder) {
  if (::unshare(CLONE_NEWNS) != 0) return "a mount namespace of its own: " + reason();
  if (::mount(nullptr, "/", nullptr, MS_REC | MS_PRIVATE, nullptr) != 0) {
    return "private mounts: " + reason();
  }
  if (::mount("none", folder.c_str(), "tmpfs", 0, "size=2g") != 0) {
    return "a file system in memory: " + reason();
  }
  return "";
}

std::vector<char> make_base(const FileSystem& system, const std::string& image,
                            std::string& error) {
  { std::ofstream create(image); }
  const std::string line = std::string(system.make) + " " + image + " >/dev/null 2>&1";
  if (::truncate(image.c_str(), static_cast<off_t>(system.bytes)) != 0 ||
      std::system(line.c_str()) != 0) {
    error = line + " failed";
    return {};
  }
  std::ifstream file(image, std::ios::binary);
  std::vector<char> bytes(system.bytes);
  file.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  return bytes;
}

bool repair(const FileSystem& system, const std::string& image) {
  if (*system.mend == '\0') return false;
  const std::string line = std::string(system.mend) + " " + image + " >/dev/null 2>&1";
  return std::system(line.c_str()) >= 0;
}

Mount::Mount(const FileSystem& system, const std::string& image, std::string folder,
             std::string& error)
    : folder_(std::move(folder)) {
  std::string device;
  const int loop = attach(image, device);
  if (loop < 0) {
    error = "a loop device: " + reason();
    return;
  }
  is_mounted_ =
      ::mount(device.c_str(), folder_.c_str(), system.name, MS_NOATIME, system.options) == 0;
  if (!is_mounted_) error = std::string("mount of ") + system.name + ": " + reason();
  ::close(loop);  // the mount now keeps the loop device open
}

Mount::~Mount() {
  for (int attempt = 0; is_mounted_ && attempt < 100; ++attempt) {
    if (::umount2(folder_.c_str(), 0) == 0) return;
    ::usleep(10'000);
  }
  if (is_mounted_) ::umount2(folder_.c_str(), MNT_DETACH);
}

}  // namespace felt::power_cut
