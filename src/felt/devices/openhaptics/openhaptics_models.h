#pragma once

#include <string_view>

#include "felt/driver/device_models.h"
#include "felt/driver/plane_calibration.h"

namespace felt {

/// The row for what a device calls its model ("PHANToM Omni", "Touch X"): by words, in whatever
/// case. What nobody knows is the generic one, the weakest of all.
const DeviceModel& openhaptics_model(std::string_view model_type) noexcept;

/// What a device says of itself; 0 or nonsense where it says nothing. In the maker's units.
struct HdLimits {
  double max_force_n = 0.0;
  double continuous_force_n = 0.0;
  double max_stiffness_n_per_mm = 0.0;
  double max_damping_n_s_per_mm = 0.0;
  double usable_mm[6] = {};  ///< least x y z, most x y z
  int update_rate_hz = 0;
};

/// Of the row and the device's own word the lesser, where the latter makes sense. The workspace is
/// the device's, or the row's.
Capabilities openhaptics_capabilities(const Capabilities& row, const HdLimits& said) noexcept;

/// The desk-parallel plane: the sheet's x is the device's (to the right), down the sheet is towards
/// the person (z), and up from the sheet is up (y). The middle of the workspace is the sheet's
/// (0, 0), at half of its height.
PlaneCalibration openhaptics_plane(const Capabilities& device) noexcept;

}  // namespace felt
