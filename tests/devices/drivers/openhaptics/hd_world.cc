#include "tests/devices/drivers/openhaptics/hd_world.h"

#include <algorithm>

#include "felt/devices/openhaptics/hd_abi.h"

namespace felt {

PlaneCalibration hd_plane(const Capabilities& page_capabilities) {
  const Vec3 middle = 0.5 * (page_capabilities.workspace_min + page_capabilities.workspace_max);
  // Page (x, y, z) = device (x, z, y), shifted.
  return *PlaneCalibration::from({Vec3{1, 0, 0}, Vec3{0, 0, 1}, Vec3{0, 1, 0}},
                                 {middle.x, middle.y, 60.0});
}

FakeHdModel hd_model(const Capabilities& page_capabilities, const PlaneCalibration& plane,
                     const char* type) {
  const Vec3 a = plane.to_device(page_capabilities.workspace_min);
  const Vec3 b = plane.to_device(page_capabilities.workspace_max);
  return {.name = "Default Device",
          .second_name = nullptr,
          .opens_without_name = 1,
          .type = type,
          .serial = "FAKE-0001",
          .max_force_n = page_capabilities.max_force_n,
          .continuous_force_n = page_capabilities.continuous_force_n,
          .stiffness_n_per_mm = 1e-3 * page_capabilities.max_stiffness_n_per_m,
          .damping_n_s_per_mm = 1e-3 * page_capabilities.max_damping_n_s_per_m,
          .usable_mm = {std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z),
                        std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)},
          .calibration_style = hd::calibration::kInkwell,
          .rate_hz = 1000,
          .has_thermometers = 1};
}

}  // namespace felt
