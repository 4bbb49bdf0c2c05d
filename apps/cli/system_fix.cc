#include "system_fix.h"

#include <spawn.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <set>
#include <string_view>
#include <system_error>
#include <utility>

#include "felt/base/atomic_file.h"
#include "print.h"

namespace felt::cli {
namespace {

constexpr mode_t kEverybodyReads = 0644;

bool is_allowed(std::string_view path) {
  for (const std::string_view folder : {"/etc/udev/rules.d/", "/etc/security/limits.d/"}) {
    if (!path.starts_with(folder)) continue;
    const std::string_view name = path.substr(folder.size());
    return !name.empty() && name.front() != '.' &&
           std::all_of(name.begin(), name.end(), [](char c) {
             return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-' || c == '.' ||
                    c == '_';
           });
  }
  return false;
}

/// Adds a fix to the list. If several devices need a line in the same file, combines their fixes,
/// so that the file is written once.
void add_fix(std::vector<SystemFix>& fixes, const SystemFix& fix) {
  const auto same = std::find_if(fixes.begin(), fixes.end(),
                                 [&fix](const SystemFix& other) { return other.path == fix.path; });
  if (same == fixes.end()) {
    fixes.push_back(fix);
  } else if (same->content.find(fix.content) == std::string::npos) {
    same->content += fix.content;
  }
}

std::vector<SystemFix> fixes_of(const DoctorReport& report) {
  std::vector<SystemFix> fixes;
  const auto gather = [&fixes](const std::vector<Finding>& findings) {
    for (const Finding& finding : findings) {
      if (finding.fix) add_fix(fixes, *finding.fix);
    }
  };
  for (const DriverReport& look : report.drivers) gather(look.findings);
  gather(report.machine);
  return fixes;
}

Result<void> check(const SystemFix& fix) {
  if (!is_allowed(fix.path)) {
    return fail(ErrorCode::kInvalidArgument,
                fix.path + ": Feltline does not write to this location; nothing was done");
  }
  if (!fix.activate.empty() && fix.activate != kReloadUdev) {
    return fail(ErrorCode::kInvalidArgument,
                fix.path + ": '" + fix.activate + "' is not a command that Feltline runs as root");
  }
  return {};
}

std::string shown(const std::vector<std::string>& command) {
  std::string text;
  for (const std::string& word : command) {
    const bool is_plain = word.find_first_of(" &'\"") == std::string::npos;
    text += (text.empty() ? "" : " ") + (is_plain ? word : "'" + word + "'");
  }
  return text;
}

Result<void> run(const std::vector<std::string>& command) {
  say("  {}\n", shown(command));
  std::vector<char*> words;
  words.reserve(command.size() + 1);
  for (const std::string& word : command) words.push_back(const_cast<char*>(word.c_str()));
  words.push_back(nullptr);
  pid_t pid = -1;
  if (const int error = posix_spawnp(&pid, words[0], nullptr, nullptr, words.data(), environ)) {
    return fail(ErrorCode::kIo, command[0] + ": " + std::strerror(error));
  }
  int status = 0;
  while (waitpid(pid, &status, 0) < 0 && errno == EINTR) {
  }
  if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return {};
  return fail(ErrorCode::kIo, "'" + shown(command) + "' failed");
}

/// Returns the words that must precede a command so that it runs as root, or an empty list if the
/// program already runs as root. Fails if neither sudo nor pkexec exists.
Result<std::vector<std::string>> as_root() {
  if (geteuid() == 0) return std::vector<std::string>{};
  for (const char* folder : {"/usr/bin/", "/bin/", "/usr/local/bin/"}) {
    for (const char* name : {"sudo", "pkexec"}) {
      const std::string path = std::string(folder) + name;
      if (access(path.c_str(), X_OK) == 0) return std::vector<std::string>{path};
    }
  }
  return fail(ErrorCode::kUnsupported,
              "neither sudo nor pkexec is installed. Write the files below a folder of yours "
              "('feltline doctor --fix --prefix FOLDER') and copy them from there as root");
}

Result<void> write_here(const PlannedFix& fix) {
  std::error_code error;
  std::filesystem::create_directories(std::filesystem::path(fix.path).parent_path(), error);
  if (error) return fail(ErrorCode::kIo, fix.path + ": " + error.message());
  if (Result<void> done = save_file(fix.path, fix.content); !done) return done;
  if (chmod(fix.path.c_str(), kEverybodyReads) != 0) {
    return fail(ErrorCode::kIo, fix.path + ": " + std::strerror(errno));
  }
  return {};
}

/// A temporary file that the user owns and that a command then copies as root.
class TemporaryFile {
 public:
  explicit TemporaryFile(std::string_view content) {
    std::error_code error;
    const std::filesystem::path folder = std::filesystem::temp_directory_path(error);
    path_ = (folder / "feltline-fix-XXXXXX").string();
    if (error) {
      errno = error.value();  // for the error message; is_good() returns false
      return;
    }
    fd_ = mkstemp(path_.data());
    is_good_ = fd_ >= 0 &&
               ::write(fd_, content.data(), content.size()) == static_cast<ssize_t>(content.size());
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  ~TemporaryFile() {
    if (fd_ < 0) return;
    close(fd_);
    unlink(path_.c_str());
  }
  [[nodiscard]] bool is_good() const noexcept { return is_good_; }
  [[nodiscard]] const std::string& path() const noexcept { return path_; }

 private:
  std::string path_;
  int fd_ = -1;
  bool is_good_ = false;
};

std::vector<std::string_view> lines_of(std::string_view text) {
  std::vector<std::string_view> lines;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size() - 1);
    lines.push_back(text.substr(0, end + (text[end] == '\n' ? 0 : 1)));
    text.remove_prefix(end + 1);
  }
  return lines;
}

/// Returns the present content of our file with the missing lines appended. Lines of an earlier run
/// stay, because they may be for a device that is not plugged in now, or for another user.
std::string with_missing_lines(const std::string& present, const std::string& wanted) {
  std::vector<std::string_view> there = lines_of(present);
  std::string missing;
  bool says_something = false;  // a missing line is not a comment
  for (const std::string_view line : lines_of(wanted)) {
    if (line.empty() || std::find(there.begin(), there.end(), line) != there.end()) continue;
    there.push_back(line);
    missing += std::string(line) + '\n';
    says_something |= line.front() != '#';
  }
  if (!says_something) return present;
  return present + (present.ends_with('\n') ? "" : "\n") + missing;
}

}  // namespace

Result<std::vector<PlannedFix>> plan_fixes(const DoctorReport& report, const SystemView& system,
                                           const std::string& prefix) {
  std::vector<PlannedFix> plan;
  for (const SystemFix& fix : fixes_of(report)) {
    if (Result<void> fine = check(fix); !fine) return tl::unexpected(fine.error());
    PlannedFix next;
    next.path = prefix + fix.path;
    next.content = std::string(kOurFileMark) + fix.content;
    if (!next.content.ends_with('\n')) next.content += '\n';
    if (prefix.empty()) next.activate = fix.activate;
    const std::optional<std::string> present = system.read(next.path);
    if (present && present->starts_with(kOurFileMark)) {
      next.content = with_missing_lines(*present, next.content);
    }
    if (present == next.content) {
      next.state = PlannedFix::State::kSame;
    } else if (present && present->starts_with(kOurFileMark)) {
      next.state = PlannedFix::State::kOurs;
    } else if (system.exists(next.path)) {
      next.state = PlannedFix::State::kForeign;
    }
    plan.push_back(std::move(next));
  }
  return plan;
}

std::string plan_text(const std::vector<PlannedFix>& fixes) {
  std::string text;
  for (const PlannedFix& fix : fixes) {
    switch (fix.state) {
      case PlannedFix::State::kSame:
        text += fix.path + " already exists with the right content.\n\n";
        continue;
      case PlannedFix::State::kNew:
        text += "A new file, " + fix.path + ":\n";
        break;
      case PlannedFix::State::kOurs:
        text += fix.path + ", which Feltline wrote before, keeps its entries and becomes:\n";
        break;
      case PlannedFix::State::kForeign:
        text += fix.path + " exists, and Feltline did not write it. It would become:\n";
        break;
    }
    for (std::size_t at = 0; at < fix.content.size();) {
      const std::size_t end = fix.content.find('\n', at);
      text += "  | " + fix.content.substr(at, end - at) + "\n";
      at = end + 1;
    }
    if (!fix.activate.empty()) text += "and then, as root:\n  " + fix.activate + "\n";
    text += "\n";
  }
  return text;
}

Result<void> write_fix(const PlannedFix& fix, bool has_prefix) {
  if (has_prefix) return write_here(fix);
  const Result<std::vector<std::string>> root = as_root();
  if (!root) return tl::unexpected(root.error());
  if (root->empty()) return write_here(fix);
  const TemporaryFile file(fix.content);
  if (!file.is_good()) return fail(ErrorCode::kIo, file.path() + ": " + std::strerror(errno));
  std::vector<std::string> command = *root;
  command.insert(command.end(), {"install", "-D", "-m", "644", file.path(), fix.path});
  return run(command);
}

Result<void> activate_fixes(const std::vector<PlannedFix>& written) {
  std::set<std::string> done;
  for (const PlannedFix& fix : written) {
    if (fix.activate.empty() || !done.insert(fix.activate).second) continue;
    Result<std::vector<std::string>> command = as_root();
    if (!command) return tl::unexpected(command.error());
    command->insert(command->end(), {"sh", "-c", fix.activate});
    if (Result<void> ran = run(*command); !ran) return ran;
  }
  return {};
}

}  // namespace felt::cli
