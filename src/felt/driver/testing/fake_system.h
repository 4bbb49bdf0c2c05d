#pragma once

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "felt/driver/diagnosis.h"

namespace felt {

/// A fake machine for tests of Driver::diagnose and of `feltline doctor`. Initially it has no file,
/// no library and no listening port, and its user is in no group.
///
///   FakeSystem system;
///   system.set_user("ada", {"users"})
///       .add_file("/sys/class/hidraw/hidraw0/device/uevent", "HID_ID=0003:00002988:00000302\n")
///       .add_file("/dev/hidraw0").forbid("/dev/hidraw0")
///       .refuse_library("libHD.so.3.4", "libncurses.so.5: cannot open shared object file: ...");
///   const std::vector<Finding> findings = driver->diagnose(system);
///
/// A folder exists as soon as it contains something. A link may also point to a folder.
class FakeSystem final : public SystemView {
 public:
  static constexpr std::string_view kNotAllowed = "Permission denied";
  static constexpr std::string_view kNoSuchFile = "No such file or directory";

  /// Adds a file that this user may read and write, until forbid() is called.
  FakeSystem& add_file(const std::string& path, std::string content = {}) {
    files_[path] = std::move(content);
    return *this;
  }
  FakeSystem& add_folder(const std::string& path) {
    folders_.insert(path);
    return *this;
  }
  /// Adds a link. `target` is absolute, or relative to the link's folder, and may end in "..".
  FakeSystem& add_link(const std::string& path, const std::string& target) {
    links_[path] = tidy(target.starts_with('/') ? target : parent(path) + "/" + target);
    return *this;
  }
  FakeSystem& remove(const std::string& path) {
    files_.erase(path);
    folders_.erase(path);
    links_.erase(path);
    return *this;
  }
  /// Makes an existing file inaccessible to this user, with errno's text `words`.
  FakeSystem& forbid(const std::string& path, std::string_view words = kNotAllowed) {
    forbidden_[tidy(path)] = words;
    return *this;
  }
  FakeSystem& allow(const std::string& path) {
    forbidden_.erase(tidy(path));
    return *this;
  }
  FakeSystem& set_user(std::string name, std::vector<std::string> groups = {}) {
    user_ = std::move(name);
    groups_ = std::move(groups);
    return *this;
  }
  FakeSystem& set_environment(const std::string& name, std::string value) {
    environment_[name] = std::move(value);
    return *this;
  }
  /// Adds a library that loads: "libHD.so", or a path.
  FakeSystem& add_library(const std::string& name) {
    libraries_[name] = {};
    return *this;
  }
  /// Adds a library that fails to load, with this text of dlerror(). Any other library is not
  /// found.
  FakeSystem& refuse_library(const std::string& name, std::string words) {
    libraries_[name] = std::move(words);
    return *this;
  }
  FakeSystem& add_listener(std::uint16_t port, const std::string& host = "localhost") {
    listeners_.insert({host, port});
    return *this;
  }

  [[nodiscard]] std::vector<std::string> list(std::string_view folder) const override;
  [[nodiscard]] std::optional<std::string> read(std::string_view path) const override;
  [[nodiscard]] bool exists(std::string_view path) const override;
  [[nodiscard]] Result<void> may_use(std::string_view path) const override;
  [[nodiscard]] std::string resolve(std::string_view path) const override;
  [[nodiscard]] std::string user() const override { return user_; }
  [[nodiscard]] std::vector<std::string> groups() const override { return groups_; }
  [[nodiscard]] std::optional<std::string> environment(std::string_view name) const override {
    const auto found = environment_.find(name);
    return found != environment_.end() ? std::optional(found->second) : std::nullopt;
  }
  [[nodiscard]] Result<void> try_library(const std::string& name) const override {
    const auto found = libraries_.find(name);
    if (found == libraries_.end())
      return fail(ErrorCode::kNotFound,
                  name + ": cannot open shared object file: " + std::string(kNoSuchFile));
    if (!found->second.empty()) return fail(ErrorCode::kNotFound, found->second);
    return {};
  }
  [[nodiscard]] bool listens(const std::string& host, std::uint16_t port) const override {
    return listeners_.contains({host, port});
  }

 private:
  static constexpr int kMaxLinks = 16;  // limit, so that a cycle of links does not repeat forever

  static std::string parent(std::string_view path) {
    return std::string(path.substr(0, path.rfind('/')));
  }
  /// Returns `path` without ".", "..", double slashes and a trailing slash.
  static std::string tidy(std::string_view path);
  /// Returns `path` with all links resolved.
  [[nodiscard]] std::string followed(std::string_view path) const;

  std::map<std::string, std::string> files_;
  std::set<std::string> folders_;
  std::map<std::string, std::string> links_;
  std::map<std::string, std::string> forbidden_;
  std::string user_ = "ada";
  std::vector<std::string> groups_;
  std::map<std::string, std::string, std::less<>> environment_;
  std::map<std::string, std::string> libraries_;
  std::set<std::pair<std::string, std::uint16_t>> listeners_;
};

inline std::string FakeSystem::tidy(std::string_view path) {
  std::vector<std::string_view> parts;
  for (std::size_t at = 0; at < path.size();) {
    const std::size_t end = std::min(path.find('/', at), path.size());
    const std::string_view part = path.substr(at, end - at);
    if (part == ".." && !parts.empty()) parts.pop_back();
    if (!part.empty() && part != "." && part != "..") parts.push_back(part);
    at = end + 1;
  }
  std::string whole;
  for (const std::string_view part : parts) (whole += '/') += part;
  return whole;
}

inline std::string FakeSystem::followed(std::string_view path) const {
  std::string at = tidy(path);
  for (int i = 0; i < kMaxLinks; ++i) {
    const auto link = std::find_if(links_.begin(), links_.end(), [&at](const auto& entry) {
      return at == entry.first || at.starts_with(entry.first + "/");
    });
    if (link == links_.end()) return at;
    at = tidy(link->second + at.substr(link->first.size()));
  }
  return at;
}

inline std::vector<std::string> FakeSystem::list(std::string_view folder) const {
  const std::string begin = followed(folder) + "/";
  std::set<std::string> names;
  const auto note = [&](const std::string& path) {
    if (!path.starts_with(begin) || path.size() == begin.size()) return;
    names.insert(path.substr(begin.size(), path.find('/', begin.size()) - begin.size()));
  };
  for (const auto& entry : files_) note(entry.first);
  for (const auto& entry : links_) note(entry.first);
  for (const std::string& path : folders_) note(path);
  return {names.begin(), names.end()};
}

inline std::optional<std::string> FakeSystem::read(std::string_view path) const {
  const std::string at = followed(path);
  const auto found = files_.find(at);
  if (found == files_.end() || forbidden_.contains(at)) return std::nullopt;
  return found->second;
}

inline bool FakeSystem::exists(std::string_view path) const {
  const std::string at = followed(path);
  return files_.contains(at) || folders_.contains(at) || !list(at).empty();
}

inline Result<void> FakeSystem::may_use(std::string_view path) const {
  const std::string name(path);
  if (!exists(path)) return fail(ErrorCode::kNotFound, name + ": " + std::string(kNoSuchFile));
  const auto found = forbidden_.find(followed(path));
  if (found != forbidden_.end()) return fail(ErrorCode::kIo, name + ": " + found->second);
  return {};
}

inline std::string FakeSystem::resolve(std::string_view path) const {
  const std::string tidied = tidy(path);
  if (tidied.empty()) return {};
  if (links_.contains(tidied)) return followed(tidied);
  // The path of the parent folder may contain links, too.
  const std::string real = followed(parent(tidied)) + tidied.substr(tidied.rfind('/'));
  return links_.contains(real) ? followed(real) : std::string();
}

}  // namespace felt
