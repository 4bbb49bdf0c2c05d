#include "tests/reliability/power_cut/log_disk.h"

#define FUSE_USE_VERSION 35
#include <errno.h>
#include <fuse.h>
#include <signal.h>
#include <string.h>
#include <sys/mount.h>
#include <sys/prctl.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>

namespace felt::power_cut {
namespace {

// State of the process that serves the file system.
std::vector<char> content;
WriteLog* served_log = nullptr;

bool is_disk(const char* path) {
  return strcmp(path, "/disk") == 0;
}

int get_attributes(const char* path, struct stat* info, struct fuse_file_info*) {
  *info = {};
  if (strcmp(path, "/") == 0) {
    info->st_mode = S_IFDIR | 0700;
    info->st_nlink = 2;
    return 0;
  }
  if (!is_disk(path)) return -ENOENT;
  info->st_mode = S_IFREG | 0600;
  info->st_nlink = 1;
  info->st_size = static_cast<off_t>(content.size());
  return 0;
}

int open_disk(const char* path, struct fuse_file_info*) {
  return is_disk(path) ? 0 : -ENOENT;
}

int read_disk(const char*, char* into, size_t size, off_t offset, struct fuse_file_info*) {
  const auto at = static_cast<size_t>(offset);
  if (at >= content.size()) return 0;
  const size_t count = std::min(size, content.size() - at);
  memcpy(into, content.data() + at, count);
  return static_cast<int>(count);
}

int write_disk(const char*, const char* bytes, size_t size, off_t offset, struct fuse_file_info*) {
  const auto at = static_cast<size_t>(offset);
  if (at + size > content.size()) return -ENOSPC;
  memcpy(content.data() + at, bytes, size);
  return served_log->add_write(at, bytes, size) ? static_cast<int>(size) : -EIO;
}

int sync_disk(const char*, int, struct fuse_file_info*) {
  return served_log->add_flush() ? 0 : -EIO;
}

[[noreturn]] void serve(const std::string& folder) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  struct fuse_operations operations = {};
  operations.getattr = get_attributes;
  operations.open = open_disk;
  operations.read = read_disk;
  operations.write = write_disk;
  operations.fsync = sync_disk;
  char name[] = "log_disk";
  char* arguments[] = {name, nullptr};
  struct fuse_args list = FUSE_ARGS_INIT(1, arguments);
  struct fuse* fuse = ::fuse_new(&list, &operations, sizeof operations, nullptr);
  if (fuse == nullptr || ::fuse_mount(fuse, folder.c_str()) != 0) ::_exit(1);
  ::fuse_loop(fuse);
  ::_exit(0);
}

}  // namespace

LogDisk::LogDisk(std::string folder, const std::vector<char>& base, WriteLog& log,
                 std::string& error)
    : folder_(std::move(folder)) {
  server_ = ::fork();
  if (server_ == 0) {
    content = base;
    served_log = &log;
    serve(folder_);
  }
  struct stat info {};
  for (int i = 0; i < 1000; ++i) {
    if (::stat(path().c_str(), &info) == 0) return;
    if (::waitpid(server_, nullptr, WNOHANG) == server_) {
      server_ = -1;
      break;
    }
    ::usleep(5000);
  }
  error = "FUSE does not mount at " + folder_;
}

LogDisk::~LogDisk() {
  ::umount2(folder_.c_str(), MNT_DETACH);
  if (server_ > 0) ::waitpid(server_, nullptr, 0);
}

}  // namespace felt::power_cut
