#pragma once

#include <cmath>

#include "felt/driver/plane_calibration.h"
#include "felt/rt/device.h"
#include "tests/devices/drivers/openhaptics/fake_libhd.h"

namespace felt {

/// The simulated device behind the fake library. Poses are rotated from the frame of the surface
/// into the vendor's axes (x right, y up, z towards the user), and forces are rotated back.
class HdWorld {
 public:
  /// Requires that `device` outlives this object.
  HdWorld(Device& device, const PlaneCalibration& plane) : device_(device), plane_(plane) {}

  [[nodiscard]] FakeHdWorld world() noexcept { return {this, read, write, stop}; }
  [[nodiscard]] const PlaneCalibration& plane() const noexcept { return plane_; }

 private:
  static constexpr std::int64_t kSilenceNs = 20'000'000;
  static constexpr double kDegPerRad = 57.295779513082320877;

  static int code(DeviceFault fault) noexcept { return 1 + static_cast<int>(fault); }

  static int read(void* self, std::int64_t now_ns, FakeHdPen* pen) {
    HdWorld& world = *static_cast<HdWorld*>(self);
    const auto sample = world.device_.read(now_ns);
    if (!sample) return code(sample.error());
    // The device sends nothing new, which the library reports as a communication error.
    if (now_ns - sample->time_ns > kSilenceNs) return code(DeviceFault::kDisconnected);
    const Vec3 p = world.plane_.to_device(sample->position);
    const Vec3 v = world.plane_.turn_to_device(sample->velocity);
    // A hand without a tilt holds the pen upright.
    const double tilt_rad = sample->tilt_deg.value_or(0.0) / kDegPerRad;
    const Vec3 axis =
        world.plane_.turn_to_device(Vec3{std::sin(tilt_rad), 0.0, std::cos(tilt_rad)});
    *pen = {{p.x, p.y, p.z}, {v.x, v.y, v.z}, sample->buttons, {axis.x, axis.y, axis.z}};
    return 0;
  }
  static int write(void* self, const double* f) {
    HdWorld& world = *static_cast<HdWorld*>(self);
    const Vec3 force = world.plane_.turn_to_page(Vec3{f[0], f[1], f[2]});
    const auto done = world.device_.write({force.x, force.y, force.z});
    return done ? 0 : code(done.error());
  }
  static void stop(void* self) { static_cast<HdWorld*>(self)->device_.stop(); }

  Device& device_;
  PlaneCalibration plane_;
};

/// Returns the vendor's axes above a desk, for a page on which the device reaches its `workspace`.
/// The origin of the device is 60 mm above the middle of the desk.
PlaneCalibration hd_plane(const Capabilities& page_capabilities);
/// Returns the values that a device with these capabilities reports, in the vendor's units and
/// axes.
FakeHdModel hd_model(const Capabilities& page_capabilities, const PlaneCalibration& plane,
                     const char* type);

}  // namespace felt
