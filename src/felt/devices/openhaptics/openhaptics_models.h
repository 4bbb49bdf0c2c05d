#pragma once

#include <string_view>

#include "felt/driver/device_models.h"
#include "felt/driver/plane_calibration.h"

namespace felt {

/// Returns the row of device_models() for the model name that a device reports ("PHANToM Omni",
/// "Touch X"). Searches for known words in the name, ignoring case. Returns the generic row, which
/// has the lowest limits, if the name is unknown.
const DeviceModel& openhaptics_model(std::string_view model_type) noexcept;

/// The limits that a device reports, in the maker's units. A limit that is not finite or not above
/// 0 counts as unknown.
struct HdLimits {
  double max_force_n = 0.0;
  double continuous_force_n = 0.0;
  double max_stiffness_n_per_mm = 0.0;
  double max_damping_n_s_per_mm = 0.0;
  double usable_mm[6] = {};  ///< minimum x y z, maximum x y z
  int update_rate_hz = 0;
};

/// Returns the capabilities of `row`, changed as follows. If the device reports a valid limit that
/// is lower than the limit in `row`, the reported limit is used. If it reports a valid workspace or
/// an update rate of 250 to 5000 Hz, these are used.
Capabilities openhaptics_capabilities(const Capabilities& row, const HdLimits& said) noexcept;

/// Returns the plane that is parallel to the desk: the page's x is the device's x (to the right),
/// the page's downward direction is the device's z (towards the user), and the direction out of the
/// page is the device's y (up). The page's (0, 0) is the centre of the workspace, at half of its
/// height.
PlaneCalibration openhaptics_plane(const Capabilities& device) noexcept;

}  // namespace felt
