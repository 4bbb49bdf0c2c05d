#include "felt/devices/openhaptics/openhaptics_doctor.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

namespace felt {
namespace {

constexpr std::string_view kUsbVendor = "2988";
constexpr std::string_view kUsbProduct = "0302";
constexpr std::string_view kUsbFolder = "/sys/bus/usb/devices";
constexpr std::string_view kConfigEnd = ".config";

// A library that may be missing, its name for the user, and how to install it.
struct Part {
  std::string_view file;
  std::string_view what;
  std::string_view step;
};
constexpr std::array kParts{
    Part{"libncurses.so.5", "an old library for text on terminals",
         "Install it:\nsudo apt install libncurses5"},
    Part{"libtinfo.so.5", "an old library for text on terminals",
         "Install it:\nsudo apt install libtinfo5"},
    Part{"libPhantomIOLib42.so", "the driver of the Touch",
         "Install the Touch device driver for Linux from 3D Systems (support.3dsystems.com, "
         "\"OpenHaptics for Linux\") by following its instructions"},
    Part{"libPHANToMIO.so.4", "the driver of the PHANToM devices",
         "Install the PHANToM device driver that came with this OpenHaptics, or the newer "
         "OpenHaptics with the Touch device driver from 3D Systems (support.3dsystems.com)"},
};

std::string trimmed(std::string text) {
  const auto is_space = [](char c) { return c == ' ' || c == '\n' || c == '\r' || c == '\t'; };
  while (!text.empty() && is_space(text.back())) text.pop_back();
  return text;
}

struct UsbDevice {
  std::string folder;  // in sysfs
  std::string node;    // "/dev/bus/usb/001/004"
};

std::string three_digits(const std::string& number) {
  return std::string(number.size() < 3 ? 3 - number.size() : 0, '0') + number;
}

std::vector<UsbDevice> touches(const SystemView& system) {
  std::vector<UsbDevice> found;
  for (const std::string& name : system.list(kUsbFolder)) {
    const std::string folder = std::string(kUsbFolder) + "/" + name;
    const auto say = [&](std::string_view what) {
      return trimmed(system.read(folder + "/" + std::string(what)).value_or(""));
    };
    if (say("idVendor") != kUsbVendor || say("idProduct") != kUsbProduct) continue;
    found.push_back({folder, "/dev/bus/usb/" + three_digits(say("busnum")) + "/" +
                                 three_digits(say("devnum"))});
  }
  return found;
}

// Returns the nodes that belong to a USB device: /dev/hidrawN of a Touch HID, /dev/ttyACMN of a
// Touch USB.
std::vector<std::string> nodes_of(const SystemView& system, const UsbDevice& device) {
  const std::string real = system.resolve(device.folder);
  const std::string begin = (real.empty() ? device.folder : real) + "/";
  std::vector<std::string> nodes;
  for (const std::string_view kind : {"hidraw", "tty"}) {
    const std::string class_folder = "/sys/class/" + std::string(kind);
    for (const std::string& name : system.list(class_folder)) {
      if (system.resolve(class_folder + "/" + name).starts_with(begin)) {
        nodes.push_back("/dev/" + name);
      }
    }
  }
  return nodes;
}

std::string config_folder(const SystemView& system) {
  const std::optional<std::string> home = system.environment(kHdConfigVariable);
  return (home && !home->empty() ? *home : std::string(kHdConfigHome)) + "/config";
}

std::string udev_rules() {
  const std::string ids = "ATTRS{idVendor}==\"" + std::string(kUsbVendor) +
                          "\", ATTRS{idProduct}==\"" + std::string(kUsbProduct) +
                          "\", TAG+=\"uaccess\"\n";
  return "# 3D Systems Touch: who sits at this computer may use it.\n"
         "SUBSYSTEM==\"hidraw\", " +
         ids + "SUBSYSTEM==\"tty\", " + ids + "SUBSYSTEM==\"usb\", " + ids;
}

// The result of trying to load the library.
struct LibraryLook {
  std::string found;  // the name that could be loaded
  std::string tried;  // the loader's errors for all other names
  const Part* part = nullptr;
  bool is_there_but_broken = false;
};

LibraryLook look_for_library(const SystemView& system, std::span<const std::string> names) {
  LibraryLook look;
  for (const std::string& name : names) {
    const Result<void> loaded = system.try_library(name);
    if (loaded) {
      look.found = name;
      return look;
    }
    const std::string& words = loaded.error().message;
    look.tried += (look.tried.empty() ? "" : "\n") + words;
    for (const Part& part : kParts) {
      if (words.find(part.file) != std::string::npos && look.part == nullptr) look.part = &part;
    }
    // The loader's message begins with the missing file. If that is not `name`, a dependency is
    // missing or something else is wrong.
    const bool is_absent = words.starts_with(name + ": cannot open shared object file: No such");
    look.is_there_but_broken = look.is_there_but_broken || !is_absent;
  }
  return look;
}

Finding broken_library(const LibraryLook& look) {
  Finding finding{.level = FindingLevel::kProblem, .what = {}, .details = look.tried};
  if (look.part != nullptr) {
    finding.what = "The OpenHaptics library is installed, but " + std::string(look.part->what) +
                   ", which it needs, is missing (" + std::string(look.part->file) + ").";
    finding.steps = {std::string(look.part->step)};
    return finding;
  }
  if (look.tried.find("ELFCLASS32") != std::string::npos) {
    finding.what = "The installed OpenHaptics library is for 32-bit programs.";
    finding.steps = {"Install the 64-bit one (\"amd64\") from 3D Systems"};
    return finding;
  }
  finding.what = "The OpenHaptics library is installed, but could not be loaded.";
  finding.steps = {
      "The message below names the missing file. Install the package that contains it:\n"
      "apt-file search FILE",
      "If no file is missing, install OpenHaptics and the Touch device driver again"};
  return finding;
}

// Reports a library that can be loaded but is not the one that the driver needs.
Finding strange_library(const LibraryLook& look, const std::string& refusal) {
  return {
      .level = FindingLevel::kProblem,
      .what = look.found + " was loaded, but is not the OpenHaptics library or is too old.",
      .details = refusal,
      .steps = {
          "Install the newest \"OpenHaptics for Linux\" from 3D Systems "
          "(support.3dsystems.com)",
          "If FELT_OPENHAPTICS_LIBRARY is set, set it to libHD.so, or let Feltline search for it:\n"
          "unset FELT_OPENHAPTICS_LIBRARY"}};
}

Finding missing_library(const LibraryLook& look, bool owns_one) {
  return {.level = owns_one ? FindingLevel::kProblem : FindingLevel::kAbsent,
          .what = owns_one
                      ? "A device by 3D Systems is connected, but its library, OpenHaptics, is not "
                        "installed."
                      : "OpenHaptics, the library for devices by 3D Systems, is not installed.",
          .details = look.tried,
          .steps = {"Get \"OpenHaptics for Linux\" and the Touch device driver from 3D Systems "
                    "(support.3dsystems.com), and follow their instructions to install both",
                    "If it is in another folder, set its path:\n"
                    "export FELT_OPENHAPTICS_LIBRARY=/path/to/libHD.so"}};
}

std::optional<Finding> look_at_setup(const SystemView& system) {
  const std::optional<std::string> home = system.environment(kHdConfigVariable);
  const bool is_new_driver = system.exists("/usr/lib/libPhantomIOLib42.so") || home.has_value() ||
                             system.exists(kHdConfigHome);
  if (!is_new_driver) return std::nullopt;  // older drivers store theirs elsewhere
  const std::string folder = config_folder(system);
  const std::vector<std::string> names = configured_devices(system);
  if (!names.empty() && home) {
    std::string all;
    for (const std::string& name : names) all += (all.empty() ? "" : ", ") + name;
    return Finding{.what = "Set up with the maker's program: " + all + "."};
  }
  Finding finding{.level = FindingLevel::kProblem, .what = {}};
  if (!home) {
    finding.what = "The environment does not define the folder of the Touch driver's settings (" +
                   std::string(kHdConfigVariable) + ").";
    finding.steps = {"Add it for all users:\necho 'GTDD_HOME=\"" + std::string(kHdConfigHome) +
                         "\"' | sudo tee -a /etc/environment",
                     "Log out and in again"};
  } else {
    finding.what = "No device has been set up with the maker's program yet.";
    finding.details = "no *.config file in " + folder;
  }
  if (names.empty()) {
    if (!system.may_use(folder)) {
      finding.steps.push_back(
          "Create the folder for its settings, and give yourself permission to write there:\n"
          "sudo mkdir -p " +
          folder + " && sudo chown " + system.user() + " " + folder);
    }
    finding.steps.push_back(
        "Pair the device in the program that came with its driver (leave the name as it is):\n"
        "Touch_Setup");
  }
  return finding;
}

Finding no_permission(const SystemView& system, const std::string& words, bool is_tty) {
  Finding finding{.level = FindingLevel::kProblem,
                  .what = "The device is connected, but " + system.user() +
                          " does not have permission to use it.",
                  .details = words,
                  .steps = {"Let Feltline do it:\nfeltline doctor --fix",
                            "Unplug the device and plug it in again"},
                  .fix = SystemFix{.path = std::string(kHdUdevRules),
                                   .content = udev_rules(),
                                   .activate = std::string(kReloadUdev)}};
  const std::vector<std::string> groups = system.groups();
  const std::string group = is_tty ? "dialout" : "plugdev";
  if (std::find(groups.begin(), groups.end(), group) == groups.end()) {
    finding.steps.push_back(
        "Or, for remote use, join the group that has access, then log out and in again:\nsudo "
        "usermod -aG " +
        group + " " + system.user());
  }
  return finding;
}

Finding look_at_device(const SystemView& system, bool has_library) {
  const std::vector<UsbDevice> found = touches(system);
  if (found.empty()) {
    return {.level = has_library ? FindingLevel::kWarning : FindingLevel::kAbsent,
            .what = "No Touch was found on USB (as " + std::string(kUsbVendor) + ":" +
                    std::string(kUsbProduct) + ").",
            .steps = {"Check that its power supply is plugged in and that it is switched on",
                      "Plug its USB cable into this computer, not into a hub",
                      "Devices on FireWire, Ethernet or a printer port are not detected here. "
                      "Check whether it opens:\n"
                      "feltline device-test openhaptics:default"}};
  }
  for (const UsbDevice& device : found) {
    std::vector<std::string> nodes = nodes_of(system, device);
    if (nodes.empty()) nodes.push_back(device.node);
    for (const std::string& node : nodes) {
      const Result<void> usable = system.may_use(node);
      if (usable || usable.error().code == ErrorCode::kNotFound) continue;
      return no_permission(system, usable.error().message, node.starts_with("/dev/tty"));
    }
  }
  return {.what = found.size() == 1 ? "A Touch is connected and can be used."
                                    : std::to_string(found.size()) +
                                          " Touch devices are connected and can be used."};
}

}  // namespace

std::vector<std::string> configured_devices(const SystemView& system) {
  std::vector<std::string> names;
  for (const std::string& file : system.list(config_folder(system))) {
    if (!file.ends_with(kConfigEnd) || file.size() == kConfigEnd.size()) continue;
    names.push_back(file.substr(0, file.size() - kConfigEnd.size()));
  }
  return names;
}

bool touch_is_on_usb(const SystemView& system) {
  return !touches(system).empty();
}

std::vector<Finding> diagnose_openhaptics(const SystemView& system,
                                          std::span<const std::string> libraries,
                                          const std::string& refusal) {
  std::vector<Finding> findings;
  const LibraryLook look = look_for_library(system, libraries);
  const bool is_on_usb = touch_is_on_usb(system);
  if (!look.found.empty() && !refusal.empty()) {
    findings.push_back(strange_library(look, refusal));
  } else if (!look.found.empty()) {
    const std::string target = system.resolve("/usr/lib/" + look.found);
    findings.push_back({.what = "OpenHaptics is installed (" + look.found + ").",
                        .details = target.empty() ? std::string() : "version: " + target});
  } else if (look.is_there_but_broken) {
    findings.push_back(broken_library(look));
  } else {
    findings.push_back(missing_library(look, is_on_usb));
    if (!is_on_usb) return findings;
  }
  if (auto setup = look_at_setup(system)) findings.push_back(*std::move(setup));
  findings.push_back(look_at_device(system, !look.found.empty()));
  return findings;
}

}  // namespace felt
