#include "felt/driver/device_profile.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <span>
#include <system_error>
#include <utility>

#include "felt/base/atomic_file.h"
#include "felt/base/hash.h"
#include "felt/base/read_file.h"
#include "felt/base/utf8.h"

namespace felt {
namespace {

constexpr std::size_t kMaxProfileBytes = 64 * 1024;
constexpr std::size_t kLongestName = 120;  // length of a file name, without its fingerprint
constexpr std::size_t kLongestText = 200;  // length of a value
constexpr double kMaxProfileNumber = 1e6;
constexpr double kLargestAreaMm = 1e4;

/// The parts of a plane, collected line by line.
struct PlaneParts {
  std::array<std::optional<Vec3>, 3> rows;
  std::optional<Vec3> origin;
  double scale = 1.0;
  std::optional<Vec3> area_middle;
  std::optional<Point> area;
  bool has_scale = false;
};

struct HandParts {
  PlaneParts right, left;
};

// No device for hands has more; larger ones are grams or a slip.
constexpr double kMaxFrictionN = 10.0, kMaxMassKg = 10.0;

constexpr std::string_view kLeft = "left_";  // prefix of the keys of the left hand's plane

std::string_view trimmed(std::string_view text) noexcept {
  constexpr std::string_view kBlank = " \t\r";
  const std::size_t first = text.find_first_not_of(kBlank);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kBlank) - first + 1);
}

/// Parses exactly this many finite numbers, separated by blanks.
template <std::size_t Count>
Result<std::array<double, Count>> numbers(std::string_view text) {
  std::array<double, Count> values{};
  for (double& value : values) {
    text = trimmed(text);
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || !std::isfinite(value) || std::fabs(value) > kMaxProfileNumber) {
      return invalid_data(Count == 1 ? std::string("is not a number")
                                     : "is not " + std::to_string(Count) + " numbers");
    }
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    if (!text.empty() && text.front() != ' ' && text.front() != '\t') {
      return invalid_data("has text after a number");
    }
  }
  if (!trimmed(text).empty())
    return invalid_data("has more than " + std::to_string(Count) + " numbers");
  return values;
}

Result<void> set(std::optional<Vec3>& to, std::string_view text) {
  const auto read = numbers<3>(text);
  if (!read) return tl::unexpected(read.error());
  to = Vec3{(*read)[0], (*read)[1], (*read)[2]};
  return {};
}

Result<void> set(std::string& to, std::string_view text) {
  if (text.size() > kLongestText) return invalid_data("is longer than 200 bytes");
  if (!is_utf8(text)) return invalid_data("is not UTF-8");
  to = text;
  return {};
}

Result<void> set(std::optional<double>& to, std::string_view text, double smallest,
                 double largest = kMaxProfileNumber) {
  const auto read = numbers<1>(text);
  if (!read) return tl::unexpected(read.error());
  if ((*read)[0] < smallest) return invalid_data("is too small");
  if ((*read)[0] > largest) return invalid_data("is too large");
  to = (*read)[0];
  return {};
}

Result<void> set_hand(bool& left_handed, std::string_view text) {
  if (text != "left" && text != "right") return invalid_data("must be \"left\" or \"right\"");
  left_handed = text == "left";
  return {};
}

Result<void> set_scale(PlaneParts& parts, std::string_view text) {
  const auto read = numbers<1>(text);
  if (!read) return tl::unexpected(read.error());
  if (!((*read)[0] >= kMinPageScale && (*read)[0] <= kMaxPageScale)) {
    return invalid_data("is not between 0.5 and 2");
  }
  parts.scale = (*read)[0];
  parts.has_scale = true;
  return {};
}

Result<void> set_area(PlaneParts& parts, std::string_view text) {
  const auto read = numbers<2>(text);
  if (!read) return tl::unexpected(read.error());
  for (const double side : *read) {
    if (!(side > 0.0 && side <= kLargestAreaMm))
      return invalid_data("must be a width and a height");
  }
  parts.area = Point{(*read)[0], (*read)[1]};
  return {};
}

/// Sets the part of a plane with this key. Returns false if `key` does not belong to a plane.
Result<bool> set_part(PlaneParts& parts, std::string_view key, std::string_view text) {
  Result<void> done;
  if (key == "plane_x" || key == "plane_y" || key == "plane_z") {
    done = set(parts.rows[static_cast<std::size_t>(key.back() - 'x')], text);
  } else if (key == "plane_origin_mm") {
    done = set(parts.origin, text);
  } else if (key == "plane_scale") {
    done = set_scale(parts, text);
  } else if (key == "area_middle_mm") {
    done = set(parts.area_middle, text);
  } else if (key == "area_mm") {
    done = set_area(parts, text);
  } else {
    return false;
  }
  if (!done) return tl::unexpected(done.error());
  return true;
}

/// Sets the value with this key. Returns false if `key` is unknown.
Result<bool> set_value(DeviceProfile& profile, HandParts& parts, std::string_view key,
                       std::string_view text) {
  Result<void> done;
  if (key == "device") {
    done = set(profile.device_id, text);
  } else if (key == "serial") {
    done = set(profile.serial, text);
  } else if (key == "name") {
    done = set(profile.name, text);
  } else if (key == "hand") {
    done = set_hand(profile.left_handed, text);
  } else if (key == "force_limit_n") {
    done = set(profile.force_limit_n, text, kMinForceLimitN);
  } else if (key == "stiffness_cap_n_per_m") {
    done = set(profile.stiffness_cap_n_per_m, text, kMinStiffnessCap);
  } else if (key == "friction_n") {
    done = set(profile.friction_n, text, 0.0, kMaxFrictionN);
  } else if (key == "mass_kg") {
    done = set(profile.mass_kg, text, 0.0, kMaxMassKg);
  } else if (key.substr(0, kLeft.size()) == kLeft) {
    return set_part(parts.left, key.substr(kLeft.size()), text);
  } else {
    return set_part(parts.right, key, text);
  }
  if (!done) return tl::unexpected(done.error());
  return true;
}

Result<void> put_together(std::optional<PlaneCalibration>& plane, std::optional<DrawingArea>& area,
                          const PlaneParts& parts, const std::string& hand) {
  const auto& rows = parts.rows;
  const auto known = std::count_if(rows.begin(), rows.end(),
                                   [](const std::optional<Vec3>& row) { return row.has_value(); });
  if (known == 3 && parts.origin) {
    plane = PlaneCalibration::from({*rows[0], *rows[1], *rows[2]}, *parts.origin, parts.scale);
    if (!plane) {
      return invalid_data("the rows of the " + std::string(hand.empty() ? "" : "left hand's ") +
                          "plane must have length 1 and be perpendicular");
    }
  } else if (known > 0 || parts.origin || parts.has_scale) {
    return invalid_data("the plane is incomplete; it needs " + hand + "plane_x, " + hand +
                        "plane_y, " + hand + "plane_z, " + hand + "plane_origin_mm");
  }
  if (parts.area.has_value() != parts.area_middle.has_value()) {
    return invalid_data("of " + hand + "area_mm and " + hand + "area_middle_mm there is only one");
  }
  if (parts.area) area = DrawingArea{*parts.area_middle, parts.area->x, parts.area->y};
  return {};
}

Result<void> put_together(DeviceProfile& profile, const HandParts& parts) {
  const PlaneParts& now = profile.left_handed ? parts.left : parts.right;
  const PlaneParts& other = profile.left_handed ? parts.right : parts.left;
  const std::string left(kLeft);
  if (Result<void> whole =
          put_together(profile.plane, profile.area, now, profile.left_handed ? left : "");
      !whole) {
    return whole;
  }
  if (Result<void> whole = put_together(profile.other_plane, profile.other_area, other,
                                        profile.left_handed ? "" : left);
      !whole) {
    return whole;
  }
  if (profile.device_id.empty()) return invalid_data("does not name its device");
  return {};
}

void add_numbers(std::string& text, std::string_view key, std::initializer_list<double> values) {
  text.append(key).append(" =");
  for (const double value : values) {
    std::array<char, 32> digits{};
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
    text.append(" ").append(digits.data(), end);
  }
  text += '\n';
}

void add_text(std::string& text, std::string_view key, std::string_view value) {
  if (!value.empty()) text.append(key).append(" = ").append(value).append("\n");
}

void add_plane(std::string& text, const std::string& hand,
               const std::optional<PlaneCalibration>& plane,
               const std::optional<DrawingArea>& area) {
  if (plane) {
    constexpr std::array<std::string_view, 3> kRows{"plane_x", "plane_y", "plane_z"};
    for (std::size_t i = 0; i < kRows.size(); ++i) {
      const Vec3& row = plane->rows()[i];
      add_numbers(text, hand + std::string(kRows[i]), {row.x, row.y, row.z});
    }
    const Vec3& origin = plane->offset();
    add_numbers(text, hand + "plane_origin_mm", {origin.x, origin.y, origin.z});
    if (plane->scale() != 1.0) add_numbers(text, hand + "plane_scale", {plane->scale()});
  }
  if (area) {
    const Vec3& middle = area->middle_mm;
    add_numbers(text, hand + "area_middle_mm", {middle.x, middle.y, middle.z});
    add_numbers(text, hand + "area_mm", {area->width_mm, area->height_mm});
  }
}

}  // namespace

bool is_of(const DeviceProfile& profile, std::string_view serial) noexcept {
  return profile.serial.empty() || serial.empty() || profile.serial == serial;
}

void switch_hand(DeviceProfile& profile) noexcept {
  profile.left_handed = !profile.left_handed;
  std::swap(profile.plane, profile.other_plane);
  std::swap(profile.area, profile.other_area);
}

void forget_planes_of_another(DeviceProfile& profile, std::string_view serial) {
  if (!is_of(profile, serial)) {
    profile.plane = profile.other_plane = std::nullopt;
    profile.area = profile.other_area = std::nullopt;
    profile.friction_n = profile.mass_kg = std::nullopt;
  }
  if (!serial.empty()) profile.serial = serial;
}

Capabilities limited_by(const DeviceProfile& profile, Capabilities device) noexcept {
  if (const auto& limit = profile.force_limit_n) {
    device.advised_force_n =
        device.advised_force_n > 0.0 ? std::min(device.advised_force_n, *limit) : *limit;
  }
  if (const auto& cap = profile.stiffness_cap_n_per_m) {
    device.max_stiffness_n_per_m =
        device.max_stiffness_n_per_m > 0.0 ? std::min(device.max_stiffness_n_per_m, *cap) : *cap;
  }
  device.friction_n = profile.friction_n.value_or(device.friction_n);
  device.mass_kg = profile.mass_kg.value_or(device.mass_kg);
  return device;
}

Result<std::string> device_profiles_folder() {
  constexpr const char* kBelow = "/feltline/devices";
  // A path that is not absolute must be ignored (XDG Base Directory Specification).
  if (const char* config = std::getenv("XDG_CONFIG_HOME"); config != nullptr && *config == '/') {
    return std::string(config) + kBelow;
  }
  if (const char* home = std::getenv("HOME"); home != nullptr && *home == '/') {
    return std::string(home) + "/.config" + kBelow;
  }
  return fail(
      ErrorCode::kNotFound,
      "device settings cannot be saved: neither XDG_CONFIG_HOME nor HOME is set to a folder");
}

std::string device_profile_path(const std::string& folder, std::string_view device_id) {
  constexpr std::string_view kHex = "0123456789ABCDEF";
  std::string name;
  for (const char c : device_id) {
    const bool stays = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                       c == '-' || c == '_';
    const auto byte = static_cast<unsigned char>(c);
    if (stays || c == ':') {
      name += c == ':' ? '+' : c;
    } else {
      name.append({'%', kHex[byte >> 4], kHex[byte & 15]});
    }
  }
  if (name.size() > kLongestName) {
    Fnv1a print;
    print.add(std::as_bytes(std::span(device_id)));
    name.resize(kLongestName);
    name += '~';
    for (int shift = 60; shift >= 0; shift -= 4) name += kHex[(print.value() >> shift) & 15];
  }
  return folder + "/" + (name.empty() ? "_" : name) + ".conf";
}

Result<DeviceProfile> parse_device_profile(std::string_view text, const std::string& where) {
  DeviceProfile profile;
  HandParts parts;
  std::vector<std::string> seen;
  for (int line = 1; !text.empty(); ++line) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view row = trimmed(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
    if (row.empty() || row.front() == '#') continue;
    const std::string place = where + ":" + std::to_string(line) + ": ";
    const std::size_t equals = row.find('=');
    if (equals == std::string_view::npos) return invalid_data(place + "has no \"=\"");
    const std::string key(trimmed(row.substr(0, equals)));
    if (key.empty() || key.size() > kLongestText)
      return invalid_data(place + "has no name before \"=\"");
    if (std::find(seen.begin(), seen.end(), key) != seen.end()) {
      return invalid_data(place + key + " occurs twice");
    }
    seen.push_back(key);
    const Result<bool> known = set_value(profile, parts, key, trimmed(row.substr(equals + 1)));
    if (!known) return tl::unexpected(with_context(known.error(), place + key));
    if (!*known) profile.unknown.emplace_back(row);
  }
  if (const Result<void> whole = put_together(profile, parts); !whole) {
    return tl::unexpected(with_context(whole.error(), where));
  }
  return profile;
}

std::string device_profile_text(const DeviceProfile& profile) {
  std::string text = "# Feltline: settings of one device, written by Preferences > Device.\n";
  add_text(text, "device", profile.device_id);
  add_text(text, "serial", profile.serial);
  add_text(text, "name", profile.name);
  if (profile.left_handed) add_text(text, "hand", "left");
  if (profile.force_limit_n) add_numbers(text, "force_limit_n", {*profile.force_limit_n});
  if (profile.stiffness_cap_n_per_m) {
    add_numbers(text, "stiffness_cap_n_per_m", {*profile.stiffness_cap_n_per_m});
  }
  if (profile.friction_n) add_numbers(text, "friction_n", {*profile.friction_n});
  if (profile.mass_kg) add_numbers(text, "mass_kg", {*profile.mass_kg});
  const std::string left(kLeft), right;
  add_plane(text, profile.left_handed ? left : right, profile.plane, profile.area);
  add_plane(text, profile.left_handed ? right : left, profile.other_plane, profile.other_area);
  for (const std::string& line : profile.unknown) text.append(line).append("\n");
  return text;
}

Result<DeviceProfile> load_device_profile(const std::string& folder, std::string_view device_id) {
  const std::string path = device_profile_path(folder, device_id);
  DeviceProfile nothing;
  nothing.device_id = device_id;
  std::error_code error;
  if (!std::filesystem::exists(path, error) && !error) return nothing;
  const Result<std::string> text = read_regular_file(path, kMaxProfileBytes);
  if (!text) return tl::unexpected(text.error());
  Result<DeviceProfile> profile = parse_device_profile(*text, path);
  if (profile && profile->device_id != device_id) {
    return invalid_data(path + ": belongs to the device \"" + profile->device_id + "\"");
  }
  return profile;
}

Result<void> save_device_profile(const std::string& folder, const DeviceProfile& profile) {
  const std::string path = device_profile_path(folder, profile.device_id);
  const std::string text = device_profile_text(profile);
  // Parses the text again, so that no profile is written that could not be loaded.
  const Result<DeviceProfile> again = parse_device_profile(text, path);
  if (!again) return tl::unexpected(again.error());
  if (*again != profile) {
    return fail(ErrorCode::kInvalidArgument,
                path + ": a text contains a line break, or starts or ends with a blank");
  }
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) return fail(ErrorCode::kIo, folder + ": " + error.message());
  return save_file(path, text);
}

}  // namespace felt
