#include "felt/base/input_files.h"

#include <sys/stat.h>

#include <map>
#include <mutex>
#include <utility>

namespace felt {
namespace {

/// The list of one process.
struct InputFiles {
  std::mutex mutex;
  bool is_on = false;
  std::map<std::pair<dev_t, ino_t>, std::string> names;
};

InputFiles& input_files() {
  static InputFiles files;
  return files;
}

}  // namespace

void protect_input_files() {
  const std::lock_guard lock(input_files().mutex);
  input_files().is_on = true;
}

void note_input_file(int fd, const std::string& name) {
  InputFiles& files = input_files();
  const std::lock_guard lock(files.mutex);
  struct stat info {};
  if (!files.is_on || ::fstat(fd, &info) != 0 || !S_ISREG(info.st_mode)) return;
  files.names.emplace(std::pair(info.st_dev, info.st_ino), name);
}

std::optional<std::string> input_file_at(const std::string& path) {
  InputFiles& files = input_files();
  const std::lock_guard lock(files.mutex);
  struct stat info {};
  if (files.names.empty() || ::stat(path.c_str(), &info) != 0) return std::nullopt;
  const auto found = files.names.find(std::pair(info.st_dev, info.st_ino));
  return found == files.names.end() ? std::nullopt : std::optional(found->second);
}

}  // namespace felt
