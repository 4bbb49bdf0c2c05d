#include "felt/devices/hapticmaster/controller_address.h"

#include <utility>

#include "felt/devices/hapticmaster/hapticmaster_device.h"

namespace felt::hapticmaster {
namespace {

constexpr const char* kPage = "docs/devices/hapticmaster.md";

Finding no_address() {
  return {.level = FindingLevel::kAbsent,
          .what = "The address of a HapticMASTER is not set, so Feltline does not look for one.",
          .steps = {"Only for a HapticMASTER: read " + std::string(kPage) +
                        " first. The machine can hurt you.",
                    "Set the address of its controller:\nexport " + std::string(kAddressVariable) +
                        "=192.168.0.25"}};
}

Finding bad_address(const std::string& text) {
  return {.level = FindingLevel::kProblem,
          .what = std::string(kAddressVariable) + " is \"" + text + "\", which is not an address.",
          .steps = {"Correct it; a port may follow:\nexport " + std::string(kAddressVariable) +
                    "=192.168.0.25:" + std::to_string(kUsualPort)}};
}

Finding not_reached(const NetAddress& address, const Error& error) {
  return {
      .level = FindingLevel::kProblem,
      .what = "The controller of the HapticMASTER at " + address.text() + " could not be reached.",
      .details = error.message,
      .steps = {"Switch the controller on, connect it to this computer, and check whether it "
                "answers:\nping -c 3 " +
                    address.host,
                "Or is the address wrong? Check it:\necho $" + std::string(kAddressVariable)}};
}

}  // namespace

std::optional<NetAddress> controller_address(const SystemView& system) {
  const std::optional<std::string> text = system.environment(kAddressVariable);
  return text && !text->empty() ? parse_net_address(*text, kUsualPort) : std::nullopt;
}

std::vector<Finding> examine(const SystemView& system, const TcpConnect& connect,
                             std::int64_t within_ns) {
  const std::optional<std::string> text = system.environment(kAddressVariable);
  if (!text || text->empty()) return {no_address()};
  const std::optional<NetAddress> address = controller_address(system);
  if (!address) return {bad_address(*text)};
  auto stream = connect(address->host, address->port, within_ns);
  if (!stream) return {not_reached(*address, stream.error())};
  ControllerLink link(*std::move(stream));
  const Result<std::string> state = ask_controller(link, "get state");
  if (!state) {
    return {{.level = FindingLevel::kProblem,
             .what = "What answers at " + address->text() + " is not a HapticMASTER.",
             .details = state.error().message,
             .steps = {"Check the address and the port:\necho $" + std::string(kAddressVariable),
                       "If it is a HapticMASTER, please report this text: nobody has tried the "
                       "driver."}}};
  }
  return {{.what = "The controller of the HapticMASTER at " + address->text() +
                   " answers. State: " + *state + "."},
          {.level = FindingLevel::kWarning,
           .what = "Nobody has tried this machine with Feltline. It can push with 250 N.",
           .steps = {"Read " + std::string(kPage) +
                     " before you use it, and keep its emergency button in your hand."}}};
}

}  // namespace felt::hapticmaster
