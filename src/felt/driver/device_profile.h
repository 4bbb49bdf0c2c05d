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

/// What a person has set for one device, apart from any program: where its drawing plane lies, how
/// much of it they want to feel, and with which hand. Kept by the device's id in a small text file
/// that a person can read, and mend:
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
/// Each hand has its plane and area: a device stands on the side of the hand that holds it.
/// plane_..., area_... are the right hand's, left_plane_..., left_area_... the left one's.
struct DeviceProfile {
  std::string device_id;     ///< of its DeviceDescriptor
  std::string serial = {};   ///< of the device that it was made with; empty: not known then
  std::string name = {};     ///< the person's own; empty: the maker's
  bool left_handed = false;  ///< the hand that holds it now: switch_hand()
  std::optional<PlaneCalibration> plane = {};        ///< that hand's; none: nobody has shown it yet
  std::optional<DrawingArea> area = {};              ///< that was shown with it
  std::optional<PlaneCalibration> other_plane = {};  ///< likewise of the other hand
  std::optional<DrawingArea> other_area = {};
  /// The most that this person wants of it. Never raises anything: see limited_by().
  std::optional<double> force_limit_n = {};
  std::optional<double> stiffness_cap_n_per_m = {};
  /// Lines of a newer program, kept as they are.
  std::vector<std::string> unknown = {};

  friend bool operator==(const DeviceProfile&, const DeviceProfile&) = default;
};

inline constexpr double kLeastForceLimitN = 0.1;
inline constexpr double kLeastStiffnessCap = 50.0;  ///< N/m

/// True unless both serials are known and differ: then the file is of another one of its kind, and
/// its plane says nothing.
bool is_of(const DeviceProfile& profile, std::string_view serial) noexcept;

/// The other hand holds it from now on, and its plane and area are those in use.
void switch_hand(DeviceProfile& profile) noexcept;
/// Unless is_of(): no plane and no area are kept. The serial is this one from now on, if it is
/// known.
void forget_planes_of_another(DeviceProfile& profile, std::string_view serial);

/// Capabilities with the person's limits, which only ever lower them.
Capabilities limited_by(const DeviceProfile& profile, Capabilities device) noexcept;

/// "$XDG_CONFIG_HOME/feltline/devices", or below "$HOME/.config". Error: neither is set.
Result<std::string> device_profiles_folder();
/// The file of an id in a folder: letters, digits, "-", "_" stay, ":" becomes "+", all else "%41";
/// so that no two ids share one and none leads out of the folder. A very long id ends in a
/// fingerprint.
std::string device_profile_path(const std::string& folder, std::string_view device_id);

/// Reads the text of a profile; `where` is for messages ("FILE:LINE: reason").
Result<DeviceProfile> parse_device_profile(std::string_view text, const std::string& where);
std::string device_profile_text(const DeviceProfile& profile);

/// What is kept for a device; where there is no file, a profile with nothing set. Error: it cannot
/// be read or makes no sense; names file, line and reason, and nothing of it should be used.
Result<DeviceProfile> load_device_profile(const std::string& folder, std::string_view device_id);
/// Writes it whole or not at all; makes the folder. Error: names file and reason, or the value that
/// makes no sense.
Result<void> save_device_profile(const std::string& folder, const DeviceProfile& profile);

}  // namespace felt
