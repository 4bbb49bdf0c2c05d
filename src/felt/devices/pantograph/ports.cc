#include "felt/devices/pantograph/ports.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "felt/devices/pantograph/board.h"

namespace felt::pantograph {
namespace {

constexpr const char* kById = "/dev/serial/by-id";
constexpr const char* kRules = "/etc/udev/rules.d/70-feltline-2diy.rules";
// USB vendors of boards like Haply's: Arduino's two, and Atmel.
constexpr std::array<std::string_view, 3> kVendors{"2341", "2a03", "03eb"};

bool looks_like_a_board(std::string name) {
  std::transform(name.begin(), name.end(), name.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
  constexpr std::array<std::string_view, 4> kWords{"haply", "arduino", "atmel", "due"};
  return std::any_of(kWords.begin(), kWords.end(), [&name](std::string_view word) {
    return name.find(word) != std::string::npos;
  });
}

std::string base_name(const std::string& path) {
  return path.substr(path.rfind('/') + 1);
}

std::string rules() {
  std::string text;
  for (const std::string_view vendor : kVendors) {
    text += "SUBSYSTEM==\"tty\", ATTRS{idVendor}==\"" + std::string(vendor) +
            "\", TAG+=\"uaccess\", ENV{ID_MM_DEVICE_IGNORE}=\"1\"\n";
  }
  return text;
}

bool has_modem_manager(const SystemView& system) {
  return system.exists("/usr/sbin/ModemManager") ||
         system.exists("/lib/systemd/system/ModemManager.service");
}

Finding nothing_there(const SystemView& system) {
  Finding finding{
      .level = FindingLevel::kAbsent,
      .what = "No serial port looks like the board of a 2DIY.",
      .steps = {"Only for a 2DIY: plug in its USB cable, and check whether a new line appears:\n"
                "ls /dev/ttyACM*"}};
  if (!system.list("/sys/class/tty").empty() || system.exists("/dev/ttyACM0")) {
    finding.steps.push_back("If it has another name, set it:\nexport " +
                            std::string(kPortVariable) + "=/dev/ttyACM0");
  }
  return finding;
}

Finding port_finding(const SystemView& system, const Port& port) {
  const Result<void> usable = system.may_use(port.path);
  if (usable) {
    return {.what = "The port " + port.path +
                    " may be a 2DIY, and you have permission to use it. Open it to check."};
  }
  Finding finding{
      .level = FindingLevel::kProblem,
      .what = "The port " + port.path + " may be a 2DIY, but you do not have permission to use it.",
      .details = usable.error().message};
  if (usable.error().code == ErrorCode::kNotFound) {
    finding.what = "The port " + port.path + " does not exist.";
    finding.steps = {"Plug in the board, or correct " + std::string(kPortVariable) +
                     ". Existing ports:\nls /dev/ttyACM* /dev/serial/by-id"};
    return finding;
  }
  finding.steps = {
      "Let Feltline write a rule that lets the user of this computer use it:\n"
      "feltline doctor --fix"};
  const auto groups = system.groups();
  if (std::find(groups.begin(), groups.end(), "dialout") == groups.end()) {
    finding.steps.push_back(
        "Or join the group of serial ports, then log out and in again:\nsudo "
        "usermod -aG dialout " +
        system.user());
  }
  finding.fix = SystemFix{.path = kRules, .content = rules(), .activate = std::string(kReloadUdev)};
  return finding;
}

}  // namespace

std::vector<Port> find_ports(const SystemView& system) {
  if (const auto named = system.environment(kPortVariable); named && !named->empty()) {
    Port port{.path = *named, .name = {}, .model = {}};
    const std::size_t colon = named->rfind(':');
    // A colon may also be part of a path in /dev/serial/by-id.
    if (colon != std::string::npos && find_board_model(named->substr(colon + 1)) != nullptr) {
      port.path = named->substr(0, colon);
      port.model = named->substr(colon + 1);
    }
    port.name = base_name(port.path);
    return {port};
  }
  std::vector<Port> ports;
  for (const std::string& name : system.list(kById)) {
    if (!looks_like_a_board(name)) continue;
    const std::string link = std::string(kById) + "/" + name;
    const std::string path = system.resolve(link);
    ports.push_back({.path = path.empty() ? link : path, .name = name, .model = {}});
  }
  return ports;
}

std::vector<Finding> examine(const SystemView& system) {
  std::vector<Finding> findings;
  const std::vector<Port> ports = find_ports(system);
  if (ports.empty()) return {nothing_there(system)};
  for (const Port& port : ports) findings.push_back(port_finding(system, port));
  if (has_modem_manager(system) && !system.exists(kRules)) {
    findings.push_back(
        {.level = FindingLevel::kWarning,
         .what = "ModemManager treats new serial ports as modems and sends data to them for some "
                 "seconds, which confuses the board.",
         .steps =
             {"Let Feltline write a rule that makes it ignore the board:\nfeltline doctor --fix",
              "Or wait half a minute after plugging the board in."},
         .fix =
             SystemFix{.path = kRules, .content = rules(), .activate = std::string(kReloadUdev)}});
  }
  return findings;
}

}  // namespace felt::pantograph
