#include "felt/driver/diagnosis.h"

#include <dlfcn.h>
#include <grp.h>
#include <pwd.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "felt/driver/byte_stream.h"

namespace felt {
namespace {

constexpr std::size_t kMaxFileBytes = 64 * 1024;
constexpr std::int64_t kListensNs =
    1'000'000'000;  // limit, because a host that is down does not answer

std::string group_name(gid_t id) {
  const group* entry = getgrgid(id);
  return entry != nullptr ? entry->gr_name : std::to_string(id);
}

class ThisSystem final : public SystemView {
 public:
  [[nodiscard]] std::vector<std::string> list(std::string_view folder) const override {
    std::vector<std::string> names;
    std::error_code error;
    for (std::filesystem::directory_iterator at(folder, error), end; !error && at != end;
         at.increment(error)) {
      names.push_back(at->path().filename().string());
    }
    std::sort(names.begin(), names.end());
    return names;
  }

  [[nodiscard]] std::optional<std::string> read(std::string_view path) const override {
    std::ifstream in{std::string(path), std::ios::binary};
    if (!in) return std::nullopt;
    std::string bytes(kMaxFileBytes, '\0');
    in.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    if (in.bad()) return std::nullopt;
    bytes.resize(static_cast<std::size_t>(in.gcount()));
    return bytes;
  }

  [[nodiscard]] bool exists(std::string_view path) const override {
    std::error_code error;
    return std::filesystem::exists(path, error);
  }

  [[nodiscard]] Result<void> may_use(std::string_view path) const override {
    const std::string name(path);
    if (access(name.c_str(), R_OK | W_OK) == 0) return {};
    const int error = errno;
    return fail(error == ENOENT ? ErrorCode::kNotFound : ErrorCode::kIo,
                name + ": " + std::strerror(error));
  }

  [[nodiscard]] std::string resolve(std::string_view path) const override {
    std::error_code error;
    if (!std::filesystem::is_symlink(path, error)) return {};
    return std::filesystem::weakly_canonical(path, error).string();
  }

  [[nodiscard]] std::string user() const override {
    const passwd* entry = getpwuid(geteuid());
    return entry != nullptr ? entry->pw_name : std::to_string(geteuid());
  }

  [[nodiscard]] std::vector<std::string> groups() const override {
    std::vector<gid_t> ids(static_cast<std::size_t>(std::max(0, getgroups(0, nullptr))));
    const int count = getgroups(static_cast<int>(ids.size()), ids.data());
    ids.resize(static_cast<std::size_t>(std::max(0, count)));
    ids.push_back(getegid());
    std::vector<std::string> names;
    names.reserve(ids.size());
    for (const gid_t id : ids) names.push_back(group_name(id));
    std::sort(names.begin(), names.end());
    names.erase(std::unique(names.begin(), names.end()), names.end());
    return names;
  }

  [[nodiscard]] std::optional<std::string> environment(std::string_view name) const override {
    const char* value = std::getenv(std::string(name).c_str());
    return value != nullptr ? std::optional<std::string>(value) : std::nullopt;
  }

  [[nodiscard]] Result<void> try_library(const std::string& name) const override {
    void* library = dlopen(name.c_str(), RTLD_LAZY | RTLD_LOCAL);
    if (library == nullptr) return fail(ErrorCode::kNotFound, dlerror());
    dlclose(library);
    return {};
  }

  [[nodiscard]] bool listens(const std::string& host, std::uint16_t port) const override {
    return TcpStream::connect(host, port, kListensNs).has_value();
  }
};

}  // namespace

const SystemView& this_system() {
  static const ThisSystem system;
  return system;
}

}  // namespace felt
