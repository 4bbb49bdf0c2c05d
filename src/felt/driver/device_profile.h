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

/// The user's settings for one device, independent of any program: where its drawing plane lies,
/// its force limits, and which hand holds it. Stored under the device's id in a small text file
/// that a user can read and repair:
///
///   # Feltline: what was set for one device.
///   device = haply:049D
///   serial = 049D
///   name = The left one
///   hand = left
///   force_limit_n = 2
///   stiffness_cap_n_per_m = 300
///   plane_x = 1 0 0
///   plane_y = 0 -1 0
///   plane_z = 0 0 1
///   plane_origin_mm = 148.5 105 -12
///   plane_scale = 1.25
///   area_middle_mm = 0 20 -15
///   area_mm = 160 120
///
/// Each hand has its own plane and area, because the device stands on the side of the hand that
/// holds it. plane_... and area_... are for the right hand, left_plane_... and left_area_... for
/// the left.
struct DeviceProfile {
  std::string device_id;                       ///< DeviceDescriptor::id
  std::string serial = {};                     ///< of the device it was made with; empty: unknown
  std::string name = {};                       ///< given by the user; empty: the maker's
  bool left_handed = false;                    ///< the hand that holds it now, see switch_hand()
  std::optional<PlaneCalibration> plane = {};  ///< for that hand; empty: not calibrated yet
  std::optional<DrawingArea> area = {};        ///< set together with the plane
  std::optional<PlaneCalibration> other_plane = {};  ///< the same for the other hand
  std::optional<DrawingArea> other_area = {};
  /// The user's limits. They never raise anything: see limited_by().
  std::optional<double> force_limit_n = {};
  std::optional<double> stiffness_cap_n_per_m = {};
  /// Lines that a newer program wrote, kept unchanged.
  std::vector<std::string> unknown = {};

  friend bool operator==(const DeviceProfile&, const DeviceProfile&) = default;
};

inline constexpr double kMinForceLimitN = 0.1;
inline constexpr double kMinStiffnessCap = 50.0;  ///< N/m

/// Returns false if both serials are known and differ. Then the profile was made with another unit
/// of the same kind, and its planes are invalid.
bool is_of(const DeviceProfile& profile, std::string_view serial) noexcept;

/// Switches the device to the other hand, with that hand's plane and area.
void switch_hand(DeviceProfile& profile) noexcept;
/// Removes all planes and areas unless is_of(). Sets the serial to `serial` if it is not empty.
void forget_planes_of_another(DeviceProfile& profile, std::string_view serial);

/// Returns `device` with the user's limits, which only ever lower it.
Capabilities limited_by(const DeviceProfile& profile, Capabilities device) noexcept;

/// Returns "$XDG_CONFIG_HOME/feltline/devices", or the folder below "$HOME/.config". Fails if
/// neither variable is set.
Result<std::string> device_profiles_folder();
/// Returns the file of an id in a folder. Letters, digits, "-" and "_" stay, ":" becomes "+",
/// anything else is escaped ("%41"), so that no two ids share a file and none leads out of the
/// folder. A very long id is cut and ends in a fingerprint.
std::string device_profile_path(const std::string& folder, std::string_view device_id);

/// Parses the text of a profile; `where` is for messages ("FILE:LINE: reason").
Result<DeviceProfile> parse_device_profile(std::string_view text, const std::string& where);
std::string device_profile_text(const DeviceProfile& profile);

/// Loads the profile of a device; without a file, a profile with nothing set. Fails if the file
/// cannot be read or is invalid, with file, line and reason; then use none of it.
Result<DeviceProfile> load_device_profile(const std::string& folder, std::string_view device_id);
/// Writes the profile atomically, and creates the folder. Fails with file and reason, or with the
/// invalid value.
Result<void> save_device_profile(const std::string& folder, const DeviceProfile& profile);

}  // namespace felt
