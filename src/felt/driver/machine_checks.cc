#include "felt/driver/machine_checks.h"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <optional>
#include <string_view>

namespace felt {
namespace {

// The number of CAP_IPC_LOCK (capabilities(7)).
constexpr int kCapIpcLock = 14;
constexpr int kCapSysNice = 23;
/// The priority that the loop requests (RealtimeOptions::fifo_priority).
constexpr int kWantedPriority = 80;
/// The first kernel with hid-haptic (kernel documentation, "HID haptic").
constexpr KernelVersion kKernelWithHaptics{6, 18};

constexpr const char* kLetFeltline = "Let Feltline write the permission:\nfeltline doctor --fix";
constexpr const char* kLogInAgain =
    "Log out and in again (or restart the computer): limits are set at login.";

/// Returns the text after a name in a file of lines such as /proc/self/status, without the blanks
/// around it.
std::string_view field_of(std::string_view text, std::string_view name) {
  std::size_t at = text.starts_with(name) ? 0 : text.find("\n" + std::string(name));
  if (at == std::string_view::npos) return {};
  at = text.find_first_not_of("\n", at) + name.size();
  std::string_view rest = text.substr(at, text.find('\n', at) - at);
  const std::size_t begin = rest.find_first_not_of(" \t");
  return begin == std::string_view::npos ? std::string_view{} : rest.substr(begin);
}

bool has_capability(const SystemView& system, int bit) {
  const std::string status = system.read("/proc/self/status").value_or("");
  const std::string_view text = field_of(status, "CapEff:");
  std::uint64_t bits = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), bits, 16);
  static_cast<void>(end);
  return error == std::errc() && ((bits >> bit) & 1U) != 0;
}

/// Returns the soft limit of this name (proc_pid_limits(5)), -1 for "unlimited", or nullopt if it
/// is unknown.
std::optional<std::int64_t> soft_limit(const SystemView& system, std::string_view name) {
  const std::string limits = system.read("/proc/self/limits").value_or("");
  const std::string_view value = field_of(limits, name);
  if (value.starts_with("unlimited")) return -1;
  std::int64_t number = 0;
  const auto [end, error] = std::from_chars(value.data(), value.data() + value.size(), number);
  static_cast<void>(end);
  return error == std::errc() ? std::optional(number) : std::nullopt;
}

bool may_run_in_real_time(const SystemView& system) {
  if (has_capability(system, kCapSysNice)) return true;
  const std::optional<std::int64_t> limit = soft_limit(system, "Max realtime priority");
  return limit && (*limit < 0 || *limit >= kWantedPriority);
}

bool may_lock_memory(const SystemView& system) {
  return has_capability(system, kCapIpcLock) || soft_limit(system, "Max locked memory") == -1;
}

/// Returns true if the name can be written to a limits file. Other texts, such as one with a line
/// break, could add further lines to the file.
bool is_plain(const std::string& user) {
  return !user.empty() && user.size() <= 32 && std::all_of(user.begin(), user.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
           c == '-' || c == '.';
  });
}

Finding real_time(const SystemView& system) {
  const bool in_time = may_run_in_real_time(system);
  const bool locks = may_lock_memory(system);
  if (in_time && locks) {
    return {.what = "Forces run in real time: they stay smooth while the computer is busy."};
  }
  Finding finding{.level = FindingLevel::kWarning, .what = {}};
  finding.what = in_time
                     ? "Forces may stutter when memory runs short, because Feltline does not have "
                       "permission to lock its memory. This matters only if you own a force device."
                     : "Forces may stutter while the computer is busy, because Feltline does not "
                       "have permission to run its force loop in real time. This matters only if "
                       "you own a force device.";
  const std::string user = system.user();
  if (!is_plain(user)) return finding;
  finding.fix = SystemFix{std::string(kLimitsFile), limits_lines(user), {}};
  if (system.exists(kLimitsFile) &&
      system.read(kLimitsFile).value_or("").find(finding.fix->content) != std::string::npos) {
    finding.what += " The permission has been written, but is not in effect yet.";
    finding.fix.reset();
    finding.steps = {kLogInAgain};
    return finding;
  }
  finding.steps = {kLetFeltline, kLogInAgain};
  return finding;
}

/// Returns the folder, or its nearest parent that exists.
std::string nearest(const SystemView& system, std::string folder) {
  while (folder.size() > 1 && !system.exists(folder)) {
    folder.resize(std::max<std::size_t>(1, folder.rfind('/')));
  }
  return folder;
}

std::string xdg_folder(const SystemView& system, const char* variable, const char* below_home) {
  const std::string set = system.environment(variable).value_or("");
  if (set.starts_with('/')) return set + "/feltline";  // other paths are ignored (XDG)
  const std::string home = system.environment("HOME").value_or("");
  return home.starts_with('/') ? home + below_home + "/feltline" : std::string();
}

/// Returns the command that lets the user write to a folder. For a folder outside the user's home,
/// returns the advice to ask the administrator.
std::string way_into(const SystemView& system, const std::string& folder) {
  const std::string home = system.environment("HOME").value_or("");
  const bool is_theirs = home.size() > 1 && folder.starts_with(home + "/") &&
                         folder.find('\'') == std::string::npos && is_plain(system.user());
  if (is_theirs) {
    return "Make yourself the owner of the folder again:\nsudo chown -R " + system.user() + " '" +
           folder + "'";
  }
  return "Ask your administrator for a home folder with write permission, or set other folders:\n"
         "export XDG_CONFIG_HOME=FOLDER XDG_STATE_HOME=FOLDER";
}

Finding folders(const SystemView& system) {
  const std::string config = xdg_folder(system, "XDG_CONFIG_HOME", "/.config");
  const std::string state = xdg_folder(system, "XDG_STATE_HOME", "/.local/state");
  if (config.empty() || state.empty()) {
    return {
        .level = FindingLevel::kProblem,
        .what =
            "Your home folder is unknown, so neither settings nor unsaved drawings can be kept.",
        .details = "the environment variable HOME is not set",
        .steps = {"Log in as a user with a home folder, or set it:\nexport HOME=/home/NAME"}};
  }
  for (const std::string& folder : {config, state}) {
    const std::string there = nearest(system, folder);
    const Result<void> use = system.may_use(there);
    if (use) continue;
    return {.level = FindingLevel::kProblem,
            .what = (folder == config ? "Settings" : "Unsaved drawings") +
                    std::string(" cannot be kept: you do not have permission to write to ") +
                    there + ".",
            .details = use.error().message,
            .steps = {way_into(system, there)}};
  }
  return {.what = "Settings are kept in " + config + ", unsaved drawings in " + state + "."};
}

Finding screen(const SystemView& system) {
  for (const char* name : {"WAYLAND_DISPLAY", "DISPLAY"}) {
    if (!system.environment(name).value_or("").empty()) {
      return {.what = "There is a screen, so feltline-desktop can open its window."};
    }
  }
  return {.level = FindingLevel::kAbsent,
          .what =
              "There is no screen in this session, so feltline-desktop cannot open its window; "
              "'feltline' works without a screen."};
}

Finding kernel(const SystemView& system) {
  const std::string release = system.read("/proc/sys/kernel/osrelease").value_or("");
  const std::string words = release.substr(0, release.find('\n'));
  if (kernel_version(system) >= kKernelWithHaptics) {
    return {.what = "The kernel (" + words + ") supports haptic touchpads."};
  }
  return {
      .level = FindingLevel::kAbsent,
      .what = "The kernel (" + (words.empty() ? "unknown" : words) +
              ") does not support haptic touchpads; 6.18 and later do. Nothing else is affected."};
}

Finding plugging(const SystemView& system) {
  if (system.exists("/run/udev/control") || system.exists("/run/udev/data")) {
    return {.what = "Devices that you plug in are detected (udev is running)."};
  }
  return {.level = FindingLevel::kAbsent,
          .what =
              "Devices that you plug in are not detected, because udev is not running (for example "
              "in a container). Run Feltline on the computer itself to use a device."};
}

}  // namespace

std::string limits_lines(const std::string& user) {
  return "# Lets the programs of this user run a loop in real time and keep it in memory.\n" +
         user + " - rtprio " + std::to_string(kWantedPriority) + "\n" + user +
         " - memlock unlimited\n";
}

KernelVersion kernel_version(const SystemView& system) {
  const std::string text = system.read("/proc/sys/kernel/osrelease").value_or("");
  const char* const end = text.data() + text.size();
  KernelVersion version;
  const auto [dot, error] = std::from_chars(text.data(), end, version.major);
  if (error != std::errc() || dot == end || *dot != '.') return {};
  if (std::from_chars(dot + 1, end, version.minor).ec != std::errc()) return {};
  return version;
}

std::vector<Finding> diagnose_machine(const SystemView& system) {
  return {folders(system), real_time(system), plugging(system), screen(system), kernel(system)};
}

}  // namespace felt
