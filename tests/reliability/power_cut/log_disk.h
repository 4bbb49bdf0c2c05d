#pragma once

#include <sys/types.h>

#include <string>
#include <vector>

#include "tests/reliability/power_cut/write_log.h"

namespace felt::power_cut {

/// A disk that remembers every write and flush: a FUSE file system of one file, `disk`, below
/// `folder`, for a loop device to stand on. A process of its own serves it, until it is unmounted
/// or this process dies.
class LogDisk {
 public:
  /// `base`: what is on the disk at first. `error` is empty where all went well.
  LogDisk(std::string folder, const std::vector<char>& base, WriteLog& log, std::string& error);
  ~LogDisk();
  LogDisk(const LogDisk&) = delete;
  LogDisk& operator=(const LogDisk&) = delete;

  [[nodiscard]] std::string path() const { return folder_ + "/disk"; }

 private:
  std::string folder_;
  pid_t server_ = -1;
};

}  // namespace felt::power_cut
