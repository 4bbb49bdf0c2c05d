#include "tests/devices/suite/driver_suite.h"

#include <array>
#include <cmath>

#include "felt/base/constants.h"
#include "felt/driver/device_models.h"
#include "felt/haptics/bricks/drawing_feel.h"
#include "felt/rt/servo.h"
#include "tests/devices/drivers/bench_device.h"

namespace felt {
namespace {

constexpr std::array kAxes{"x", "y", "z"};

double along(const Vec3& v, std::size_t axis) {
  return axis == 0 ? v.x : axis == 1 ? v.y : v.z;
}
Vec3 unit(std::size_t axis) {
  return {axis == 0 ? 1.0 : 0.0, axis == 1 ? 1.0 : 0.0, axis == 2 ? 1.0 : 0.0};
}

std::string words(const char* what, std::size_t axis, double is, double should) {
  return std::string(what) + " along " + kAxes.at(axis) + ": " + std::to_string(is) + ", not " +
         std::to_string(should);
}

// A bench with its pen above the middle of the workspace, and a running virtual time.
class Rig {
 public:
  explicit Rig(const BenchMaker& make) : bench(make({})), device(*bench) {
    const Capabilities& space = bench->world().preset().capabilities;
    middle = 0.5 * (space.workspace_min + space.workspace_max);
    middle.z = 8.0;
    bench->world().stylus().place(middle);
    aim = middle;
  }

  /// Writes a force in the frame of the surface for `ms` ms of ticks. Returns the last sample.
  PenSample hold(const Force& force, std::int64_t ms) {
    const std::int64_t period_ns = device.capabilities().period_ns;
    for (const std::int64_t end_ns = now_ns + ms * kMs; now_ns < end_ns; now_ns += period_ns) {
      bench->hand().aim(aim, {}, 0);
      if (const auto sample = device.read(now_ns);
          sample && is_finite(sample->position) && is_finite(sample->velocity)) {
        last = *sample;
      } else {
        ++unread;
      }
      if (!device.write(force)) ++unwritten;
    }
    return last;
  }

  std::unique_ptr<DriverBench> bench;
  BenchDevice device;
  Vec3 middle, aim;
  std::int64_t now_ns = 0;
  PenSample last;
  int unread = 0, unwritten = 0;
};

}  // namespace

std::string check_axes(const BenchMaker& make) {
  Rig rig(make);
  const Capabilities& can = rig.device.capabilities();
  const auto axes = static_cast<std::size_t>(can.sensed_axes);
  const PenSample before = rig.hold({}, 400);
  constexpr double kStepMm = 8.0;
  for (std::size_t axis = 0; axis < std::min<std::size_t>(axes, 3); ++axis) {
    rig.aim = rig.middle + kStepMm * unit(axis);
    (void)rig.hold({}, 30);
    const double speed = along(rig.hold({}, 10).velocity, axis);
    const Vec3 moved = rig.hold({}, 600).position - before.position;
    for (std::size_t other = 0; other < std::min<std::size_t>(axes, 3); ++other) {
      const double should = other == axis ? kStepMm : 0.0;
      if (std::fabs(along(moved, other) - should) > 1.5) {
        return words("the pen moves", other, along(moved, other), should);
      }
    }
    if (!(speed > 5.0)) return words("its velocity, mm/s,", axis, speed, kStepMm);
    rig.aim = rig.middle;
    (void)rig.hold({}, 600);
  }
  if (rig.unread > 0) return "it cannot always be read";
  if (norm(before.position - rig.middle) > 2.0 && axes > 2) return "the pen is elsewhere";
  return "";
}

std::string check_force_signs(const BenchMaker& make) {
  Rig rig(make);
  const auto axes = static_cast<std::size_t>(rig.device.capabilities().actuated_axes);
  (void)rig.hold({}, 400);
  for (std::size_t axis = 0; axis < axes; ++axis) {
    for (const double newtons : {0.4, -0.4}) {
      const PenSample before = rig.hold({}, 500);
      const Vec3 push = newtons * unit(axis);
      const PenSample after = rig.hold({push.x, push.y, push.z}, 500);
      const Force held = rig.bench->world().held_force();
      for (std::size_t other = 0; other < axes; ++other) {
        const double is = along({held.x, held.y, held.z}, other);
        const double should = other == axis ? newtons : 0.0;
        if (std::fabs(is - should) > 0.03) return words("the motors hold, N,", other, is, should);
      }
      const double moved = along(after.position - before.position, axis);
      if (axis < static_cast<std::size_t>(rig.device.capabilities().sensed_axes) &&
          !(moved * newtons > 0.0)) {
        return words("the pen moves, mm,", axis, moved, newtons);
      }
    }
  }
  rig.device.stop();
  if (rig.bench->world().held_force() != Force{}) return "stop() does not let go";
  if (rig.unwritten > 0) return "it cannot always be written";
  return std::string(rig.bench->broken_rule());
}

std::string check_pressing(const BenchMaker& make) {
  Rig rig(make);
  const Capabilities& can = rig.device.capabilities();
  if (can.actuated_axes < 3) return "";
  Servo servo(rig.device, {.period_ns = can.period_ns, .limits = limits_for(can)});
  servo.publish(ForceModel(make_surface_force(surface_materials()[0], media()[0], can)));
  servo.arm();
  double min_push_n = 1e9;
  for (std::int64_t now_ns = 0; now_ns < 1500 * kMs; now_ns += can.period_ns) {
    rig.aim = rig.middle;
    rig.aim.z = now_ns < 700 * kMs ? 5.0 : -3.0;
    rig.bench->hand().aim(rig.aim, {}, 0);
    servo.heartbeat(now_ns);
    (void)servo.step(now_ns);
    if (now_ns > 1300 * kMs) {
      min_push_n = std::min(min_push_n, rig.bench->world().held_force().z);
    }
  }
  servo.stop();
  if (!(min_push_n > 0.1)) return words("pressing is answered, N,", 2, min_push_n, 0.1);
  return std::string(rig.bench->broken_rule());
}

std::string check_words(const BenchMaker& make) {
  Rig rig(make);
  (void)rig.hold({}, 50);
  DriverDevice& device = *rig.bench->device();
  const DeviceDescriptor& said = device.descriptor();
  if (said.label.empty()) return "no label";
  if (said.kind != DeviceKind::kForce) return "it is no force device";
  const Capabilities& can = device.capabilities();
  const DeviceModel* row = find_device_model(said.model);
  if (row == nullptr && rig.bench->name() != "scripted") return "no row for model " + said.model;
  if (row != nullptr) {
    const Capabilities& largest = row->capabilities;
    if (can.max_force_n > largest.max_force_n ||
        can.continuous_force_n > largest.continuous_force_n ||
        (largest.advised_force_n > 0.0 && !(can.advised_force_n <= largest.advised_force_n))) {
      return "more force than the row of " + said.model;
    }
  }
  const DeviceStatus status = device.status();
  if (status.fault || status.last_fault) return "a fault of a healthy device";
  if (status.reads == 0) return "its reads are not counted";
  return "";
}

}  // namespace felt
