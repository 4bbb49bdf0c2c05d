#include "felt/devices/haply/haply_doctor.h"

#include <optional>
#include <string>

#include "felt/devices/haply/service_address.h"
#include "felt/devices/haply/service_messages.h"

namespace felt::haply {
namespace {

constexpr const char* kUnitFiles[] = {
    "/lib/systemd/system/haply-inverse-service.service",
    "/usr/lib/systemd/system/haply-inverse-service.service",
    "/etc/systemd/system/haply-inverse-service.service",
};
constexpr const char* kConfigFolder = "/etc/haply-inverse-service";
constexpr int kOldest = 3001;  // first version with the messages that we use
constexpr int kUsual = 3005;   // first version with presets that put the origin in the centre
constexpr int kTooNew = 4000;

bool has_unit(const SystemView& system) {
  for (const char* file : kUnitFiles) {
    if (system.exists(file)) return true;
  }
  return false;
}

Finding not_installed(const ServiceAddress& address) {
  return {.level = FindingLevel::kAbsent,
          .what = "Haply's Inverse Service is not installed: nothing listens at " +
                  address.control.text() + ".",
          .steps = {"Only for an Inverse3 or Minverse: get the Inverse Service for Linux from "
                    "haply.co (Haply Hub includes it).",
                    "Install its package:\nsudo apt install ./haply-inverse-service*.deb"}};
}

Finding not_running(const ServiceAddress& address) {
  const std::string source =
      address.source.empty() ? std::string() : " (a port from " + address.source + ")";
  Finding finding{
      .level = FindingLevel::kProblem,
      .what = "Haply's Inverse Service is not running: nothing listens at " +
              address.control.text() + source + ".",
      .steps = {"Start it, now and whenever the computer starts:\nsudo systemctl enable --now "
                "haply-inverse-service",
                "If it stops again, read its log:\njournalctl -u haply-inverse-service -n 30"}};
  if (address.source == kUrlVariable) {
    finding.steps.emplace_back("Or is " + std::string(kUrlVariable) + " wrong? Check it:\necho $" +
                               kUrlVariable);
  }
  return finding;
}

Finding version_finding(const std::string& version) {
  const int number = version_number(version);
  const std::string named = "The Inverse Service is running, version " + version + ".";
  const std::string update = "Install a newer one, from haply.co or with Haply Hub.";
  if (number == 0) {
    return {.level = FindingLevel::kWarning,
            .what = "The Inverse Service is running, but does not report its version."};
  }
  if (number < kOldest) {
    return {.level = FindingLevel::kProblem,
            .what = named + " That is too old: Feltline needs 3.1 or newer.",
            .steps = {update}};
  }
  if (number < kUsual) {
    return {
        .level = FindingLevel::kWarning,
        .what = named + " With services before 3.5 the position of the drawing plane may be wrong.",
        .steps = {"Calibrate the plane by touching three corners (in the window: Preferences, "
                  "Device, \"Set the drawing plane...\").",
                  update}};
  }
  if (number >= kTooNew) {
    return {.level = FindingLevel::kWarning,
            .what = named + " Feltline was made for 3.x and may not understand it."};
  }
  return {.what = named};
}

void add_device(const InventoryDevice& device, std::vector<Finding>& findings) {
  const std::string named =
      (device.type.empty() ? "A device" : "The " + device.type) + " \"" + device.id + "\"";
  if (device.has_power == false) {
    findings.push_back(
        {.level = FindingLevel::kProblem,
         .what = named + " has no power, so it cannot produce force.",
         .steps = {"Plug in its power supply (the USB cable alone is not enough)."}});
    return;
  }
  if (device.calibrated == false) {
    findings.push_back(
        {.level = FindingLevel::kProblem,
         .what = named + " is not calibrated.",
         .steps = {"Put the tip of its handle into the inkwell at its foot and hold it there until "
                   "the light has changed, or calibrate it in Haply Hub."}});
    return;
  }
  Finding finding{.what = named + " is connected."};
  if (device.in_use == true) {
    finding.level = FindingLevel::kWarning;
    finding.what = named + " is connected, but another program uses it: forces would add up.";
    finding.steps = {"Close the other program (a demo in Haply Hub, for example)."};
  } else if (device.gravity_compensation == false) {
    finding.level = FindingLevel::kWarning;
    finding.what = named + " is connected, but its gravity compensation is off, so its arm sinks.";
    finding.steps = {"Switch gravity compensation on in Haply Hub."};
  }
  if (device.force_gate.value_or(0.0) > 0.0 || device.damping.value_or(0.0) > 0.0) {
    finding.what += " The service's filters change our forces: force gate " +
                    std::to_string(device.force_gate.value_or(0.0)).substr(0, 4) + ", damping " +
                    std::to_string(device.damping.value_or(0.0)).substr(0, 4) + ".";
  }
  findings.push_back(finding);
}

void ask_service(const SystemView& system, const ServiceAddress& address, const TcpConnect& connect,
                 std::int64_t within_ns, std::vector<Finding>& findings) {
  const auto version = http_get(connect, address.control, "/version", within_ns);
  if (!version) {
    findings.push_back({.level = FindingLevel::kProblem,
                        .what = "A program listens at " + address.control.text() +
                                ", but does not answer like the Inverse Service.",
                        .details = version.error().message,
                        .steps = {"Find out which program it is:\nss -tlnp | grep " +
                                      std::to_string(address.control.port),
                                  "Restart the service:\nsudo systemctl restart "
                                  "haply-inverse-service"}});
    return;
  }
  findings.push_back(version_finding(read_version(*version)));
  if (!system.listens(address.events.host, address.events.port)) {
    findings.push_back(
        {.level = FindingLevel::kWarning,
         .what = "The service's events (port " + std::to_string(address.events.port) +
                 ") do not arrive, so Feltline does not know when the device brakes."});
  }
  const auto answer = http_get(connect, address.control, "/devices", within_ns);
  const std::optional<Inventory> inventory = answer ? read_inventory(*answer) : std::nullopt;
  if (!inventory) {
    findings.push_back({.level = FindingLevel::kProblem,
                        .what = "The Inverse Service does not list its devices.",
                        .details = answer ? std::string() : answer.error().message,
                        .steps = {"Restart it:\nsudo systemctl restart haply-inverse-service"}});
    return;
  }
  if (inventory->devices.empty()) {
    findings.push_back(
        {.level = FindingLevel::kProblem,
         .what = "The Inverse Service is running, but does not detect a device.",
         .steps = {
             "Connect the power supply and the USB cable of the device, and wait some seconds.",
             "Does the computer detect it? Look for a new line after plugging it in:\n"
             "ls /dev/ttyACM*"}});
  }
  for (const InventoryDevice& device : inventory->devices) add_device(device, findings);
}

}  // namespace

std::vector<Finding> examine(const SystemView& system, const TcpConnect& connect,
                             std::int64_t within_ns) {
  std::vector<Finding> findings;
  const ServiceAddress address = service_address(system);
  if (!address.wrong.empty()) {
    findings.push_back(
        {.level = FindingLevel::kProblem,
         .what = address.wrong,
         .steps = {"Correct it, or unset it: the default address is ws://localhost:10001."}});
  }
  const bool is_reported = !address.wrong.empty();
  if (system.listens(address.control.host, address.control.port)) {
    ask_service(system, address, connect, within_ns, findings);
  } else if (has_unit(system) || system.exists(kConfigFolder) || !address.source.empty()) {
    findings.push_back(not_running(address));
  } else if (!is_reported) {
    findings.push_back(not_installed(address));
  }
  return findings;
}

}  // namespace felt::haply
