#include <array>
#include <cmath>
#include <cstring>
#include <utility>

#include "felt/devices/haply/json_walk.h"
#include "felt/devices/haply/service_messages.h"
#include "felt/driver/text_writer.h"

namespace felt::haply {
namespace {

// Reads {x, y, z}; all three must be numbers.
bool read_vector(JsonScanner& json, Vec3& vector) noexcept {
  unsigned seen = 0;
  const bool is_read = walk_object(json, [&](std::string_view key) {
    const std::size_t axis = key.size() == 1 ? std::string_view("xyz").find(key[0]) : 3;
    if (axis >= 3) return json.skip_value();
    if (json.next() != JsonToken::kNumber) return false;
    (axis == 0 ? vector.x : axis == 1 ? vector.y : vector.z) = json.number();
    seen |= 1u << axis;
    return true;
  });
  return is_read && seen == 7;
}

bool read_buttons(JsonScanner& json, std::uint32_t& buttons) noexcept {
  using Name = std::pair<std::string_view, std::uint32_t>;
  constexpr std::array kNames{Name{"a", 1},        Name{"b", 2},        Name{"c", 4},
                              Name{"button_0", 1}, Name{"button_1", 2}, Name{"button_2", 4},
                              Name{"button_3", 8}};
  return walk_object(json, [&](std::string_view key) {
    std::optional<bool> is_down;
    if (!read_flag(json, is_down)) return false;
    for (const auto& [name, bit] : kNames) {
      if (key == name && is_down) buttons = *is_down ? buttons | bit : buttons & ~bit;
    }
    return true;
  });
}

// Reads a quaternion {w, x, y, z} and sets `axis` to the direction to which it rotates the grip's
// own y axis, along which the handle points. If the quaternion is invalid (null, a missing number,
// or a length that is not 1), `axis` is not set. That is not an error, because some grips do not
// have this sensor.
bool read_grip_axis(JsonScanner& json, std::optional<Vec3>& axis) noexcept {
  constexpr double kMaxOff = 0.1;
  constexpr std::string_view kParts = "wxyz";
  std::array<double, 4> q{};
  unsigned seen = 0;
  const JsonToken token = json.next();
  if (token == JsonToken::kBeginArray) return json.leave(json.depth());
  if (token != JsonToken::kBeginObject) return token != JsonToken::kBad && token != JsonToken::kEnd;
  const bool is_read = walk_entered_object(json, [&](std::string_view key) {
    const std::size_t part = key.size() == 1 ? kParts.find(key[0]) : kParts.npos;
    if (part == kParts.npos) return json.skip_value();
    const JsonToken value = json.next();
    if (value == JsonToken::kNumber) {
      q[part] = json.number();
      seen |= 1u << part;
      return true;
    }
    if (value == JsonToken::kBeginObject || value == JsonToken::kBeginArray) {
      return json.leave(json.depth());
    }
    return value != JsonToken::kBad && value != JsonToken::kEnd;
  });
  if (!is_read) return false;
  const auto [w, x, y, z] = q;
  const double size = w * w + x * x + y * y + z * z;
  if (seen == 0xF && std::abs(size - 1.0) < kMaxOff) {
    axis = Vec3{2.0 * (x * y - w * z) / size, 1.0 - 2.0 * (x * x + z * z) / size,
                2.0 * (y * z + w * x) / size};
  }
  return true;
}

// The fields of an entry of the message. They are stored until the entry's id is known, because the
// id may come last.
struct Entry {
  std::string_view id;
  State state;
};

bool read_own_state(JsonScanner& json, State& state) noexcept {
  return walk_object(json, [&](std::string_view key) {
    if (key == "cursor_position") {
      state.has_device = true;
      return read_vector(json, state.position_m);
    }
    if (key == "cursor_velocity") return read_vector(json, state.velocity_m_per_s);
    if (key == "current_cursor_force") return read_vector(json, state.force_n.emplace());
    return json.skip_value();
  });
}

bool read_grip_state(JsonScanner& json, State& state) noexcept {
  return walk_object(json, [&](std::string_view key) {
    if (key == "buttons") return read_buttons(json, state.buttons);
    if (key == "orientation") return read_grip_axis(json, state.grip_axis);
    std::optional<bool> is_down;
    if (!read_flag(json, is_down)) return false;
    if (key == "button" && is_down) state.buttons = *is_down ? 1 : 0;
    return true;
  });
}

bool read_status(JsonScanner& json, State& state) noexcept {
  return walk_object(json, [&](std::string_view key) {
    std::optional<bool> flag;
    if (!read_flag(json, flag)) return false;
    if (key == "calibrated") state.calibrated = flag;
    if (key == "power_supply") state.has_power = flag;
    return true;
  });
}

bool read_entry(JsonScanner& json, bool is_grip, Entry& entry) noexcept {
  return walk_entered_object(json, [&](std::string_view key) {
    if (key == "device_id") {
      if (json.next() != JsonToken::kString) return false;
      entry.id = json.text();
      return true;
    }
    if (key == "state") {
      return is_grip ? read_grip_state(json, entry.state) : read_own_state(json, entry.state);
    }
    if (key == "status" && !is_grip) return read_status(json, entry.state);
    return json.skip_value();
  });
}

}  // namespace

bool read_state(std::string_view message, std::string_view device_id, std::string_view grip_id,
                State& state) noexcept {
  state = {};
  State grip;
  JsonScanner json(message);
  const bool is_read = walk_object(json, [&](std::string_view key) {
    const bool is_grip = is_grip_family(key);
    if (key != "inverse3" && !is_grip) return json.skip_value();
    return walk_objects(json, [&] {
      Entry entry;
      if (!read_entry(json, is_grip, entry)) return false;
      if (is_grip && !grip_id.empty() && entry.id == grip_id) grip = entry.state;
      if (!is_grip && entry.id == device_id) state = entry.state;
      return true;
    });
  });
  state.buttons = grip.buttons;
  state.grip_axis = grip.grip_axis;
  return is_read && json.next() == JsonToken::kEnd;
}

std::string_view write_command(std::string_view device_id, ForceKey key, const Force& force,
                               char* room) noexcept {
  constexpr std::size_t kMaxId = 64;
  char* at = append_text(room, R"({"inverse3":[{"device_id":")");
  at = append_text(at, device_id.substr(0, kMaxId));
  at = append_text(at, R"(","commands":{"set_cursor_force":{")");
  at = append_text(at, key == ForceKey::kValues ? "values" : "vector");
  at = append_text(at, R"(":{"x":)");
  at = append_decimal(at, force.x);
  at = append_text(at, R"(,"y":)");
  at = append_decimal(at, force.y);
  at = append_text(at, R"(,"z":)");
  at = append_decimal(at, force.z);
  at = append_text(at, "}}}}]}");
  return {room, static_cast<std::size_t>(at - room)};
}

std::string first_command(std::string_view device_id) {
  return R"({"session":{"configure":{"profile":{"name":"org.feltline:drawing"}}},)"
         R"("inverse3":[{"device_id":")" +
         std::string(device_id) + R"(","configure":{"preset":{"preset":"arm_front_centered"}}}]})";
}

}  // namespace felt::haply
