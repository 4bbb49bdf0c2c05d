#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "felt/driver/driver.h"
#include "felt/geometry/vec3.h"
#include "felt/haptics/force.h"

/// The messages of the Inverse Service 3.x (maker's pages "WebSocket Protocol", "Control Commands",
/// "JSON Conventions", "Events & Monitoring"), parsed in place. Unknown keys are skipped. A message
/// is bad if a value that must be a number has another type.
namespace felt::haply {

/// The state of our device in a state message, in the service's units (m, m/s, N) and in the
/// coordinates of its application space.
struct State {
  bool has_device = false;  ///< our device is in the message, with a position
  Vec3 position_m;
  Vec3 velocity_m_per_s;
  std::optional<Vec3> force_n;     ///< the acting force, as reported by the service
  std::optional<bool> calibrated;  ///< if reported
  std::optional<bool> has_power;   ///< if reported
  std::uint32_t buttons = 0;       ///< of our grip; bit 0: button a, button_0 or the only button
  std::optional<Vec3>
      grip_axis;  ///< direction of our grip, if it reports its orientation; length 1
};

/// Reads a state message. `grip_id` is empty if the device has no grip. Returns false if the
/// message is bad; `state` is then undefined. Used on the haptic thread; does not allocate.
bool read_state(std::string_view message, std::string_view device_id, std::string_view grip_id,
                State& state) noexcept;

/// A device of the inventory. The service sends the inventory as its first message and as its
/// answer to GET /devices.
struct InventoryDevice {
  std::string id;          ///< letters, digits, '-', '_'; devices with other ids are left out
  std::string type;        ///< "inverse3", "inverse3x", "minverse"
  std::string firmware;    ///< "7.4"; empty if unknown
  std::string handedness;  ///< side for which the arm is built: "right" or "left"; empty if unknown
  std::string preset;      ///< empty if unknown
  std::optional<bool> calibrated, has_power, in_use;
  std::optional<bool> gravity_compensation;
  std::optional<double> force_gate;  ///< gain of the service's own guard against oscillation
  std::optional<double> damping;     ///< damping that the service adds
};
struct Inventory {
  std::vector<InventoryDevice> devices;
  std::vector<std::string> grips;  ///< ids of the grips; grips with a cable come first
};
/// Reads an inventory, either bare or inside {"ok": true, "data": ...}. Returns nullopt if the
/// message is not an inventory. Used on the edit thread.
std::optional<Inventory> read_inventory(std::string_view message);

/// Returns the newest "project_version" or "git_tag" in an answer to GET /version, or an empty
/// string if the answer contains neither.
std::string read_version(std::string_view answer);
/// Returns major and minor version as one number for comparisons, for example 3005 for
/// "3.5.0-2-gce34c39e". Returns 0 if the text is not a version.
int version_number(std::string_view version) noexcept;

/// How the driver reacts to an event.
enum class EventKind : std::uint8_t {
  kNone,     ///< does nothing
  kNotice,   ///< shows the event's text to the user
  kBrakeOn,  ///< sends no force until kBrakeOff
  kBrakeOff,
  kForceStopped,  ///< sets the force to zero until the user switches forces on again
  kGone,          ///< the device is no longer there
};
struct Event {
  EventKind kind = EventKind::kNone;
  ShortText words;  ///< the service's own text
};
/// Reads an event. Returns kNone for an event of another device, unless the event is about the
/// battery of a grip. Returns nullopt if the message is bad. Used on the haptic thread; does not
/// allocate.
std::optional<Event> read_event(std::string_view message, std::string_view device_id) noexcept;

/// The key of the force vector in the command set_cursor_force. The maker's pages disagree about
/// its name (docs/design/devices.md#haply-service).
enum class ForceKey : std::uint8_t {
  kValues,  ///< used in all examples up to 3.4, and by us if the version is unknown
  kVector,  ///< used in the reference pages of 3.5
};
constexpr ForceKey force_key_of(int version) noexcept {
  return version >= 3005 ? ForceKey::kVector : ForceKey::kValues;
}
constexpr ForceKey other(ForceKey key) noexcept {
  return key == ForceKey::kValues ? ForceKey::kVector : ForceKey::kValues;
}

/// Writes the command of one tick into `room`, which must have at least kMaxCommand bytes, and
/// returns the written text. Forces that are not finite are written as 0. Used on the haptic
/// thread.
inline constexpr std::size_t kMaxCommand = 512;
std::string_view write_command(std::string_view device_id, ForceKey key, const Force& force,
                               char* room) noexcept;
/// Returns the first message to the service, which contains our name and the origin that we want
/// (the centre of the workspace).
std::string first_command(std::string_view device_id);

}  // namespace felt::haply
