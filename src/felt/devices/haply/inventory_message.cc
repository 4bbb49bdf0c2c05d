#include <algorithm>
#include <charconv>

#include "felt/devices/haply/json_walk.h"
#include "felt/devices/haply/service_messages.h"

namespace felt::haply {
namespace {

constexpr std::size_t kMaxListedId = 64;
constexpr std::size_t kMaxDevices = 16;

// Returns true if the id can be used without escapes in a command and in our own ids.
bool is_plain_id(std::string_view id) {
  const auto is_plain = [](char c) {
    return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '-' ||
           c == '_';
  };
  return !id.empty() && id.size() <= kMaxListedId && std::all_of(id.begin(), id.end(), is_plain);
}

// Reads the next value into `text` if it is a string, and skips any other value.
bool read_text(JsonScanner& json, std::string& text) {
  JsonScanner ahead = json;
  if (ahead.next() != JsonToken::kString) return json.skip_value();
  json = ahead;
  text = json.text().substr(0, kMaxListedId);
  return true;
}

bool read_number(JsonScanner& json, std::optional<double>& number) {
  JsonScanner ahead = json;
  if (ahead.next() != JsonToken::kNumber) return json.skip_value();
  json = ahead;
  number = json.number();
  return true;
}

// Calls `read(key)` for each key if the next value is an object, and skips any other value.
template <class Read>
bool walk_if_object(JsonScanner& json, Read read) {
  JsonScanner ahead = json;
  if (ahead.next() != JsonToken::kBeginObject) return json.skip_value();
  json = ahead;
  return walk_entered_object(json, read);
}

bool read_filters(JsonScanner& json, InventoryDevice& device) {
  return walk_if_object(json, [&](std::string_view filter) {
    const bool is_gate = filter == "force_gate", is_damping = filter == "damping";
    if (!is_gate && !is_damping) return json.skip_value();
    return walk_if_object(json, [&](std::string_view key) {
      if (is_gate && key == "gain") return read_number(json, device.force_gate);
      if (is_damping && key == "scalar") return read_number(json, device.damping);
      return json.skip_value();
    });
  });
}

bool read_firmware(JsonScanner& json, InventoryDevice& device) {
  std::optional<double> major, minor;
  const bool is_read = walk_if_object(json, [&](std::string_view key) {
    if (key == "major_version") return read_number(json, major);
    if (key == "minor_version") return read_number(json, minor);
    return json.skip_value();
  });
  const auto is_small = [](const std::optional<double>& v) { return v && *v >= 0.0 && *v < 1e6; };
  if (is_small(major) && is_small(minor)) {
    device.firmware =
        std::to_string(static_cast<int>(*major)) + "." + std::to_string(static_cast<int>(*minor));
  }
  return is_read;
}

bool read_config(JsonScanner& json, InventoryDevice& device) {
  return walk_if_object(json, [&](std::string_view key) {
    if (key == "type") return read_text(json, device.type);
    if (key == "handedness") return read_text(json, device.handedness);
    if (key == "preset") return read_text(json, device.preset);
    if (key == "device_info") return read_firmware(json, device);
    if (key == "filters") return read_filters(json, device);
    if (key == "gravity_compensation") {
      return walk_if_object(json, [&](std::string_view name) {
        return name == "enabled" ? read_flag(json, device.gravity_compensation) : json.skip_value();
      });
    }
    return json.skip_value();
  });
}

bool read_device(JsonScanner& json, InventoryDevice& device) {
  return walk_entered_object(json, [&](std::string_view key) {
    if (key == "device_id") return read_text(json, device.id);
    if (key == "config") return read_config(json, device);
    if (key != "status") return json.skip_value();
    return walk_if_object(json, [&](std::string_view name) {
      if (name == "calibrated") return read_flag(json, device.calibrated);
      if (name == "power_supply") return read_flag(json, device.has_power);
      if (name == "in_use") return read_flag(json, device.in_use);
      return json.skip_value();
    });
  });
}

struct Found {
  Inventory inventory;
  std::vector<std::string> wireless;
  bool is_one = false;
};

bool read_families(JsonScanner& json, std::string_view family, Found& found) {
  found.is_one = true;
  return walk_objects(json, [&] {
    InventoryDevice device;
    if (!read_device(json, device)) return false;
    if (!is_plain_id(device.id)) return true;
    std::vector<std::string>& grips =
        family == "verse_grip" ? found.inventory.grips : found.wireless;
    if (is_grip_family(family)) {
      if (grips.size() < kMaxDevices) grips.push_back(device.id);
    } else if (found.inventory.devices.size() < kMaxDevices) {
      found.inventory.devices.push_back(device);
    }
    return true;
  });
}

bool read_message(JsonScanner& json, Found& found) {
  return walk_object(json, [&](std::string_view key) {
    if (key == "inverse3" || is_grip_family(key)) return read_families(json, key, found);
    if (key != "data") return json.skip_value();
    return walk_if_object(json, [&](std::string_view inner) {
      if (inner == "inverse3" || is_grip_family(inner)) return read_families(json, inner, found);
      return json.skip_value();
    });
  });
}

}  // namespace

std::optional<Inventory> read_inventory(std::string_view message) {
  JsonScanner json(message);
  Found found;
  if (!read_message(json, found) || json.next() != JsonToken::kEnd) return std::nullopt;
  Inventory& inventory = found.inventory;
  inventory.grips.insert(inventory.grips.end(), found.wireless.begin(), found.wireless.end());
  return found.inventory;
}

std::string read_version(std::string_view answer) {
  std::string version, tag;
  JsonScanner json(answer);
  for (;;) {
    const JsonToken token = json.next();
    if (token == JsonToken::kBad || token == JsonToken::kEnd) break;
    if (token != JsonToken::kKey) continue;
    if (json.text() == "project_version" && !read_text(json, version)) break;
    if (json.text() == "git_tag" && !read_text(json, tag)) break;
  }
  return version.empty() ? tag : version;
}

int version_number(std::string_view version) noexcept {
  constexpr int kMax = 999;
  if (version.starts_with('v')) version.remove_prefix(1);
  int major = 0, minor = 0;
  const char* const end = version.data() + version.size();
  const auto whole = std::from_chars(version.data(), end, major);
  if (whole.ec != std::errc{} || whole.ptr == end || *whole.ptr != '.') return 0;
  const auto part = std::from_chars(whole.ptr + 1, end, minor);
  if (part.ec != std::errc{} || major < 0 || minor < 0 || major > kMax || minor > kMax) return 0;
  return 1000 * major + minor;
}

}  // namespace felt::haply
