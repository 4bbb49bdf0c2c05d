#include "felt/base/same_file.h"

#include <sys/stat.h>

#include <filesystem>
#include <system_error>

#include "felt/base/file_steps.h"

namespace felt {
namespace {

std::string full_name(const std::string& path) {
  std::error_code error;
  const std::filesystem::path full = std::filesystem::absolute(file_steps::resolved(path), error);
  const std::filesystem::path canonical = std::filesystem::weakly_canonical(full, error);
  return error ? path : canonical.string();
}

}  // namespace

bool is_same_file(const std::string& a, const std::string& b) {
  struct stat at_a {
  }, at_b{};
  const bool has_a = ::stat(a.c_str(), &at_a) == 0, has_b = ::stat(b.c_str(), &at_b) == 0;
  if (has_a != has_b) return false;
  if (!has_a) return full_name(a) == full_name(b);
  return S_ISREG(at_a.st_mode) && at_a.st_dev == at_b.st_dev && at_a.st_ino == at_b.st_ino;
}

}  // namespace felt
