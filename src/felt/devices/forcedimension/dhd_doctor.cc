#include "felt/devices/forcedimension/dhd_doctor.h"

#include <algorithm>
#include <string_view>

#include "felt/devices/forcedimension/dhd_library.h"

namespace felt::dhd {
namespace {

constexpr std::string_view kUsbFolder = "/sys/bus/usb/devices";
constexpr std::string_view kRulesPath = "/etc/udev/rules.d/70-feltline-forcedimension.rules";
constexpr std::string_view kSdkPage = "https://www.forcedimension.com/software/sdk";

constexpr std::string_view kConnect =
    "Connect its USB cable and its power supply, and switch it on.";

struct UsbDevice {
  std::string label;
  std::string node;  // /dev/bus/usb/001/004
};

// Returns the text of a sysfs file without its line break.
std::string line_of(const SystemView& system, const std::string& path) {
  std::string text = system.read(path).value_or("");
  text.erase(std::find_if(text.begin(), text.end(),
                          [](char c) { return static_cast<unsigned char>(c) < ' '; }),
             text.end());
  return text;
}

std::string padded(const std::string& number) {
  return number.size() < 3 ? std::string(3 - number.size(), '0') + number : number;
}

std::vector<UsbDevice> usb_devices(const SystemView& system) {
  std::vector<UsbDevice> found;
  for (const std::string& name : system.list(kUsbFolder)) {
    const std::string folder = std::string(kUsbFolder) + "/" + name;
    const std::string vendor = line_of(system, folder + "/idVendor");
    const bool is_falcon = vendor == "0403" && line_of(system, folder + "/idProduct") == "cb48";
    if (!is_falcon && vendor != "1451") continue;
    const std::string product = line_of(system, folder + "/product");
    found.push_back({is_falcon         ? "Novint Falcon"
                     : product.empty() ? "Force Dimension device"
                                       : "Force Dimension device (" + product + ")",
                     "/dev/bus/usb/" + padded(line_of(system, folder + "/busnum")) + "/" +
                         padded(line_of(system, folder + "/devnum"))});
  }
  return found;
}

SystemFix udev_rule() {
  return {std::string(kRulesPath),
          "# Force Dimension's devices and the Novint Falcon, for whoever sits at this computer.\n"
          "SUBSYSTEM==\"usb\", ATTR{idVendor}==\"1451\", MODE=\"0660\", TAG+=\"uaccess\"\n"
          "SUBSYSTEM==\"usb\", ATTR{idVendor}==\"0403\", ATTR{idProduct}==\"cb48\", "
          "MODE=\"0660\", TAG+=\"uaccess\"\n",
          std::string(kReloadUdev)};
}

Finding permission_of(const SystemView& system, const UsbDevice& device) {
  if (auto may = system.may_use(device.node); !may) {
    if (may.error().code == ErrorCode::kNotFound) {
      return {FindingLevel::kProblem,
              "A " + device.label + " is connected, but its device file is missing.",
              may.error().message,
              {"Pull its USB cable out and plug it in again.",
               "In a container or virtual machine: pass the USB device through to it."}};
    }
    return {FindingLevel::kProblem,
            "A " + device.label + " is connected, but " + system.user() +
                " does not have permission to use it.",
            may.error().message,
            {"Allow the user of this computer to use it:\nfeltline doctor --fix",
             "Pull its USB cable out and plug it in again."},
            udev_rule()};
  }
  return {FindingLevel::kOk, "A " + device.label + " is connected and can be used."};
}

bool is_not_found(std::string_view words, const std::string& name) {
  // The library itself is missing. If a dependency is missing, the loader names the dependency.
  return words.find(name + ": cannot open shared object file: No such file") !=
         std::string_view::npos;
}

std::vector<std::string> steps_for(std::string_view words) {
  if (words.find("ELF") != std::string_view::npos) {
    return {
        "That file is for another processor or system. Get the SDK for Linux on this one. To show "
        "the type of this computer:\n"
        "uname -m",
        "Unpack it, and set its folder:\nexport FORCEDIM_SDK=$HOME/sdk-3.17.5"};
  }
  if (words.find("libusb") != std::string_view::npos) {
    return {"Install the library that it needs:\nsudo apt install libusb-1.0-0"};
  }
  return {"Install the library that the message names, or get the SDK again from " +
          std::string(kSdkPage)};
}

std::vector<std::string> sdk_steps() {
  return {"Get the SDK for Linux (free, at the maker's): " + std::string(kSdkPage),
          "Unpack it in your home folder:\ntar xf sdk-*.tar.gz -C ~",
          "Put the library where Feltline looks:\nmkdir -p ~/.local/lib && cp "
          "~/sdk-*/lib/release/lin-$(uname -m)-gcc/libdrd.so* ~/.local/lib/",
          "Look again:\nfeltline doctor forcedimension"};
}

// Reports a library that can be loaded but is not the one that the driver needs.
Finding strange_library(const std::string& refusal) {
  Finding finding{FindingLevel::kProblem,
                  "The library found has the name of Force Dimension's library, but is a different "
                  "one or too old.",
                  refusal, sdk_steps()};
  finding.steps.insert(finding.steps.begin(),
                       "If FELT_FORCEDIMENSION_LIBRARY is set, set it to the SDK's libdrd.so, or "
                       "let Feltline search for it:\n"
                       "unset FELT_FORCEDIMENSION_LIBRARY");
  return finding;
}

Finding library_finding(const SystemView& system, const std::string& named, bool has_device) {
  std::string refused_name, refused_words;
  for (const std::string& name : library_names(system, named)) {
    const auto loads = system.try_library(name);
    if (loads) {
      return {FindingLevel::kOk, "Force Dimension's library was found: " + name + "."};
    }
    if (refused_name.empty() && !is_not_found(loads.error().message, name)) {
      refused_name = name;
      refused_words = loads.error().message;
    }
  }
  if (!refused_name.empty()) {
    return {FindingLevel::kProblem, "Force Dimension's library was found, but could not be loaded.",
            refused_words, steps_for(refused_words)};
  }
  if (!named.empty()) {
    return {FindingLevel::kProblem,
            "FELT_FORCEDIMENSION_LIBRARY names a file that does not exist: " + named + ".",
            {},
            {"Set it to the SDK's libdrd.so, or let Feltline search for it:\n"
             "unset FELT_FORCEDIMENSION_LIBRARY"}};
  }
  if (has_device) {
    return {FindingLevel::kProblem,
            "Force Dimension's library (libdrd.so) was not found. It is part of the SDK, which "
            "Feltline is not allowed to include.",
            {},
            sdk_steps()};
  }
  Finding absent{
      FindingLevel::kAbsent,
      "No device by Force Dimension or Novint is connected, and their library is not installed.",
      {},
      sdk_steps()};
  absent.steps.insert(absent.steps.begin(), std::string(kConnect));
  return absent;
}

}  // namespace

std::vector<Finding> diagnose(const SystemView& system, const std::string& named,
                              const std::string& last_refusal, const std::string& library_refusal) {
  const std::vector<UsbDevice> devices = usb_devices(system);
  std::vector<Finding> findings;
  for (const UsbDevice& device : devices) findings.push_back(permission_of(system, device));
  findings.push_back(library_finding(system, named, !devices.empty()));
  if (findings.back().level == FindingLevel::kOk && !library_refusal.empty()) {
    findings.back() = strange_library(library_refusal);
  }
  if (devices.empty() && findings.back().level != FindingLevel::kAbsent) {
    findings.push_back({FindingLevel::kWarning,
                        "No USB device by Force Dimension or Novint was found.",
                        {},
                        {std::string(kConnect)}});
  }
  if (!last_refusal.empty()) {
    findings.push_back(
        {FindingLevel::kProblem,
         "A device was seen, but could not be opened.",
         last_refusal,
         {"Close other programs that use it (for example the maker's).",
          "Switch its power off and on, then look again:\nfeltline doctor forcedimension"}});
  }
  return findings;
}

}  // namespace felt::dhd
