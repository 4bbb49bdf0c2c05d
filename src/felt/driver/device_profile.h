#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "felt/base/result.h"
#include "felt/driver/page_fit.h"
#include "felt/driver/plane_calibration.h"
#include "felt/haptics/capabilities.h"

namespace felt {

/// The user's settings for one device: the position of its drawing plane, its force limits, and the
/// hand that holds the device. They are stored under the device's id in a small text file that a
/// user can read and repair:
///
///   # Feltline: what was set for one device.
///   device = haply:049D
///   serial = 049D
///   name = The left one
///   hand = left
///   force_limit_n = 2
///   stiffness_cap_n_per_m = 300
///   friction_n = 0.12
///   mass_kg = 0.05
///   plane_x = 1 0 0
///   plane_y = 0 -1 0
///   plane_z = 0 0 1
///   plane_origin_mm = 148.5 105 -12
///   plane_scale = 1.25
///   area_middle_mm = 0 20 -15
///   area_mm = 160 120
///
/// Each hand has its own plane and area, because the device stands to the right or left of the
/// user, on the side of the hand that holds it. plane_... and area_... are for the right hand,
/// left_plane_... and left_area_... for the left.
struct DeviceProfile {
  std::string device_id;     ///< DeviceDescriptor::id
  std::string serial = {};   ///< serial number of the device; empty if unknown
  std::string name = {};     ///< given by the user; if empty, the maker's name is used
  bool left_handed = false;  ///< true if the left hand holds the device now; see switch_hand()
  std::optional<PlaneCalibration> plane = {};  ///< plane for that hand; nullopt if not calibrated
  std::optional<DrawingArea> area = {};        ///< set together with the plane
  std::optional<PlaneCalibration> other_plane = {};  ///< plane for the other hand
  std::optional<DrawingArea> other_area = {};
  /// The user's limits. They can only lower the device's own limits, see limited_by().
  std::optional<double> force_limit_n = {};
  std::optional<double> stiffness_cap_n_per_m = {};
  /// The friction and the moving mass that were measured on this device, instead of those of its
  /// model (Capabilities).
  std::optional<double> friction_n = {};
  std::optional<double> mass_kg = {};
  /// Lines that a newer version of Feltline wrote. They are kept unchanged.
  std::vector<std::string> unknown = {};

  friend bool operator==(const DeviceProfile&, const DeviceProfile&) = default;
};

inline constexpr double kMinForceLimitN = 0.1;
inline constexpr double kMinStiffnessCap = 50.0;  ///< N/m

/// Returns true unless the profile's serial number and `serial` are both known and differ. If they
/// differ, the profile was made with another unit of the same model, and its planes are invalid.
bool is_of(const DeviceProfile& profile, std::string_view serial) noexcept;

/// Switches the device to the other hand, with that hand's plane and area.
void switch_hand(DeviceProfile& profile) noexcept;
/// Removes all planes, areas and measurements if is_of() returns false. Sets the profile's serial
/// number to `serial` if `serial` is not empty.
void forget_planes_of_another(DeviceProfile& profile, std::string_view serial);

/// Returns `device` with the user's limits, which can only lower the limits of the device, and with
/// what was measured on it.
Capabilities limited_by(const DeviceProfile& profile, Capabilities device) noexcept;

/// Returns "$XDG_CONFIG_HOME/feltline/devices", or "$HOME/.config/feltline/devices" if that
/// variable is not set. Fails if neither variable is set.
Result<std::string> device_profiles_folder();
/// Returns the path of the profile of a device in `folder`. In the file name, letters, digits, "-"
/// and "_" of the id stay, ":" becomes "+", and other characters are escaped ("%41"), so that each
/// id has its own file. A very long name is shortened and ends in a fingerprint of the id.
std::string device_profile_path(const std::string& folder, std::string_view device_id);

/// Parses the text of a profile; `where` is for messages ("FILE:LINE: reason").
Result<DeviceProfile> parse_device_profile(std::string_view text, const std::string& where);
std::string device_profile_text(const DeviceProfile& profile);

/// Loads the profile of a device. If the file does not exist, returns an empty profile. Fails with
/// file, line and reason if the file cannot be read or is invalid.
Result<DeviceProfile> load_device_profile(const std::string& folder, std::string_view device_id);
/// Writes the profile atomically, and creates the folder. Fails with file and reason, or with the
/// invalid value.
Result<void> save_device_profile(const std::string& folder, const DeviceProfile& profile);

}  // namespace felt
