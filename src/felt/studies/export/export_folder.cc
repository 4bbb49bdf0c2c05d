#include "felt/studies/export/export_folder.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <csignal>
#include <cstring>
#include <optional>
#include <system_error>
#include <utility>
#include <vector>

#include "felt/base/file_steps.h"

namespace felt {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kHiddenEnd = ".export";

tl::unexpected<Error> export_error(const fs::path& path, const std::string& reason) {
  return fail(ErrorCode::kIo, path.string() + ": " + reason);
}

std::string hidden_name(const fs::path& target, pid_t process) {
  return "." + target.filename().string() + "." + std::to_string(process) + std::string(kHiddenEnd);
}

/// Returns the process that made a hidden folder for `target`, or nullopt for any other name.
std::optional<pid_t> maker_of(const fs::path& target, const std::string& name) {
  const std::string start = "." + target.filename().string() + ".";
  if (!name.starts_with(start) || !name.ends_with(kHiddenEnd)) return std::nullopt;
  pid_t process = 0;
  const char* const end = name.data() + name.size() - kHiddenEnd.size();
  const auto read = std::from_chars(name.data() + start.size(), end, process);
  if (read.ec != std::errc() || read.ptr != end || process < 1) return std::nullopt;
  return process;
}

/// Returns true if the process that made the folder has ended. A process of another machine looks
/// as if it had ended, but holds the lock of its folder.
bool is_abandoned(const fs::path& folder, pid_t process) {
  if (process != ::getpid() && (::kill(process, 0) == 0 || errno != ESRCH)) return false;
  const int fd =
      file_steps::open_file(folder.string(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
  if (fd < 0) return false;
  const bool is_free = ::flock(fd, LOCK_EX | LOCK_NB) == 0;
  ::close(fd);
  return is_free;
}

/// Removes the hidden folders that killed exports to `target` have left.
void remove_abandoned(const fs::path& target) {
  std::vector<fs::path> abandoned;
  std::error_code error;
  for (fs::directory_iterator entry(target.parent_path(), error), end; !error && entry != end;
       entry.increment(error)) {
    const auto process = maker_of(target, entry->path().filename().string());
    if (process && is_abandoned(entry->path(), *process)) abandoned.push_back(entry->path());
  }
  for (const fs::path& folder : abandoned) fs::remove_all(folder, error);
}

}  // namespace

Result<ExportFolder> ExportFolder::create(const std::string& out) {
  std::error_code error;
  fs::path target = fs::absolute(out, error).lexically_normal();
  if (target.filename().empty()) target = target.parent_path();
  const fs::file_status status = fs::status(target, error);
  if (fs::exists(status) && !(fs::is_directory(status) && fs::is_empty(target, error))) {
    return fail(ErrorCode::kInvalidArgument,
                out + ": exists already; name a new folder for the export");
  }
  fs::create_directories(target.parent_path(), error);
  if (error) return export_error(target.parent_path(), error.message());
  remove_abandoned(target);
  fs::path hidden = target.parent_path() / hidden_name(target, ::getpid());
  if (!fs::create_directory(hidden, error)) {
    return export_error(hidden, error ? error.message() : "exists already");
  }
  const int lock = file_steps::open_file(hidden.string(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (lock >= 0) ::flock(lock, LOCK_EX | LOCK_NB);
  return ExportFolder(std::move(target), std::move(hidden), lock);
}

ExportFolder::ExportFolder(ExportFolder&& other) noexcept
    : target_(std::move(other.target_)),
      hidden_(std::exchange(other.hidden_, {})),
      lock_(std::exchange(other.lock_, -1)) {}

ExportFolder::~ExportFolder() {
  std::error_code ignored;
  if (!hidden_.empty()) fs::remove_all(hidden_, ignored);
  if (lock_ >= 0) ::close(lock_);
}

Result<void> ExportFolder::write(const std::string& path, std::string_view bytes) const {
  const fs::path file = hidden_ / path;
  std::error_code error;
  fs::create_directories(file.parent_path(), error);
  if (error) return export_error(target_ / path, error.message());
  const int fd =
      file_steps::open_file(file.string(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  int reason = fd < 0 ? errno : 0;
  if (fd >= 0 && !file_steps::write_all(fd, bytes)) reason = errno;
  if (fd >= 0 && ::close(fd) != 0 && reason == 0) reason = errno;
  if (reason != 0) return export_error(target_ / path, std::strerror(reason));
  return {};
}

Result<void> ExportFolder::commit() {
  std::error_code error;
  fs::rename(hidden_, target_, error);  // also replaces an empty folder
  if (error) return export_error(target_, error.message());
  hidden_.clear();
  return {};
}

}  // namespace felt
