#pragma once

#include <string_view>

#include "felt/driver/device_models.h"
#include "felt/driver/plane_calibration.h"

namespace felt {

/// Returns the row of device_models() for the model name that a device reports ("PHANToM Omni",
/// "Touch X"): by words, in any case. An unknown name gives the generic row, the weakest of all.
const DeviceModel& openhaptics_model(std::string_view model_type) noexcept;

/// Limits that a device reports, in the maker's units; 0 or invalid if unknown.
struct HdLimits {
  double max_force_n = 0.0;
  double continuous_force_n = 0.0;
  double max_stiffness_n_per_mm = 0.0;
  double max_damping_n_s_per_mm = 0.0;
  double usable_mm[6] = {};  ///< minimum x y z, maximum x y z
  int update_rate_hz = 0;
};

/// Returns the lower of each limit in the row and in the report, if the latter is valid. The
/// workspace is the reported one, or the row's.
Capabilities openhaptics_capabilities(const Capabilities& row, const HdLimits& said) noexcept;

/// Returns the desk-parallel plane: the page's x is the device's (to the right), down the page is
/// towards the user (z), and up from the page is up (y). The centre of the workspace is the page's
/// (0, 0), at half of its height.
PlaneCalibration openhaptics_plane(const Capabilities& device) noexcept;

}  // namespace felt
