#include "overwrite_check.h"

#include <fmt/core.h>
#include <sys/stat.h>

#include "commands.h"
#include "felt/base/same_file.h"

namespace felt::cli {
namespace {

/// Returns the path of an input or output. "-" becomes the path `stream` of a standard stream,
/// which resolves to the file that the stream is redirected to.
std::string name_of(const std::string& path, const char* stream) {
  return path == "-" ? stream : path;
}

void note_hard_links(const std::string& path, Console& console) {
  struct stat info {};
  if (path == "-" || ::stat(path.c_str(), &info) != 0) return;
  if (!S_ISREG(info.st_mode) || info.st_nlink < 2) return;
  console.notice(fmt::format("{}: has {} more name{} (hard links), which keep{} the old content",
                             path, info.st_nlink - 1, info.st_nlink > 2 ? "s" : "",
                             info.st_nlink > 2 ? "" : "s"));
}

}  // namespace

void check_no_overwrite(const std::vector<std::string>& inputs,
                        const std::vector<GivenOutput>& outputs, Console& console) {
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    const auto& [option, path] = outputs[i];
    if (path.empty()) continue;
    const std::string name = name_of(path, "/dev/stdout");
    for (const std::string& input : inputs) {
      if (!is_same_file(name, name_of(input, "/dev/stdin"))) continue;
      throw UsageError(fmt::format(
          "{} {} would overwrite the input {}; nothing was written. Choose another file", option,
          path, input));
    }
    for (std::size_t k = 0; k < i; ++k) {
      if (outputs[k].path.empty() || !is_same_file(name, name_of(outputs[k].path, "/dev/stdout"))) {
        continue;
      }
      throw UsageError(fmt::format(
          "{} {} and {} {} are the same file; nothing was written. Choose different files",
          outputs[k].option, outputs[k].path, option, path));
    }
    note_hard_links(path, console);
  }
}

}  // namespace felt::cli
