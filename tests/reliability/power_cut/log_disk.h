#pragma once

#include <sys/types.h>

#include <string>
#include <vector>

#include "tests/reliability/power_cut/write_log.h"

namespace felt::power_cut {

/// A disk that records every write and flush. It is a FUSE file system with one file, `disk`, below
/// `folder`; a loop device can use that file. A separate process serves the file system until it is
/// unmounted or this process dies.
class LogDisk {
 public:
  /// `base` is the initial content of the disk. Sets `error`, which is empty on success.
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
