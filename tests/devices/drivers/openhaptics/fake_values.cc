#include "tests/devices/drivers/openhaptics/fake_values.h"

#include <algorithm>
#include <cmath>

#include "tests/devices/drivers/openhaptics/fake_machine.h"

namespace felt::fake_libhd {
namespace {

constexpr std::array kValues{
    Value{parameter::kButtons, Kind::kInteger, 1},
    Value{parameter::kSafetySwitch, Kind::kBoolean, 1},
    Value{parameter::kInkwell, Kind::kBoolean, 1},
    Value{parameter::kEncoders, Kind::kLong, 6},
    Value{parameter::kPosition, Kind::kReal, 3},
    Value{parameter::kVelocity, Kind::kReal, 3},
    Value{parameter::kTransform, Kind::kReal, 16},
    Value{parameter::kVersion, Kind::kText, 1},
    Value{parameter::kModelType, Kind::kText, 1},
    Value{parameter::kDriverVersion, Kind::kText, 1},
    Value{parameter::kVendor, Kind::kText, 1},
    Value{parameter::kSerialNumber, Kind::kText, 1},
    Value{parameter::kUsableWorkspace, Kind::kReal, 6},
    Value{parameter::kLargestWorkspace, Kind::kReal, 6},
    Value{parameter::kTabletopOffset, Kind::kReal, 1},
    Value{parameter::kInputDof, Kind::kInteger, 1},
    Value{parameter::kOutputDof, Kind::kInteger, 1},
    Value{parameter::kCalibrationStyle, Kind::kInteger, 1},
    Value{parameter::kUpdateRate, Kind::kInteger, 1},
    Value{parameter::kMeasuredUpdateRate, Kind::kInteger, 1},
    Value{parameter::kMaxStiffness, Kind::kReal, 1},
    Value{parameter::kMaxForce, Kind::kReal, 1},
    Value{parameter::kMaxContinuousForce, Kind::kReal, 1},
    Value{parameter::kMotorTemperature, Kind::kReal, 3},
    Value{parameter::kMaxDamping, Kind::kReal, 1},
    Value{parameter::kForce, Kind::kReal, 3},
};

double length_of(const std::array<double, 3>& v) {
  return std::hypot(v[0], v[1], v[2]);
}

/// Returns a matrix by columns: three orthogonal axes, the third along the stylus, then the
/// position.
std::array<double, 16> transform_of(const FakeHdPen& pen) {
  std::array<double, 3> z{pen.axis[0], pen.axis[1], pen.axis[2]};
  if (length_of(z) == 0.0) z = {0.0, 1.0, 0.0};
  const double size = length_of(z);
  for (double& v : z) v /= size;
  // Any other direction gives the two remaining axes.
  const bool is_along_x = std::abs(z[0]) > 0.9;
  const std::array<double, 3> beside{is_along_x ? 0.0 : 1.0, is_along_x ? 1.0 : 0.0, 0.0};
  const auto cross = [](const auto& a, const auto& b) {
    return std::array<double, 3>{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
                                 a[0] * b[1] - a[1] * b[0]};
  };
  std::array<double, 3> y = cross(z, beside);
  const double size_y = length_of(y);
  for (double& v : y) v /= size_y;
  const std::array<double, 3> x = cross(y, z);
  std::array<double, 16> out{};
  std::copy_n(x.begin(), 3, out.begin());
  std::copy_n(y.begin(), 3, out.begin() + 4);
  std::copy_n(z.begin(), 3, out.begin() + 8);
  std::copy_n(pen.position, 3, out.begin() + 12);
  out[15] = 1.0;
  return out;
}

}  // namespace

const Value* find_value(hd::Enum what, Kind kind) {
  Fake& f = fake();
  if (f.open == 0) {
    broken("asked without a device", error::kBadHandle);
    return nullptr;
  }
  for (const Value& value : kValues) {
    if (value.what != what) continue;
    const bool is_new =
        what == parameter::kMotorTemperature || what == parameter::kMeasuredUpdateRate;
    if (is_new && f.model->has_thermometers == 0) break;
    if (value.kind == kind) return &value;
    broken("a value of the wrong type", error::kInvalidInputType);
    return nullptr;
  }
  push(error::kInvalidEnum);  // not a broken rule, because programs query support like this
  return nullptr;
}

std::array<double, 16> reals(hd::Enum what) {
  const Fake& f = fake();
  const FakeHdPen& pen = f.frame.pen;
  std::array<double, 16> out{};
  switch (what) {
    case parameter::kPosition:
      std::copy_n(pen.position, 3, out.begin());
      break;
    case parameter::kVelocity:
      std::copy_n(pen.velocity, 3, out.begin());
      break;
    case parameter::kTransform:
      out = transform_of(pen);
      break;
    case parameter::kUsableWorkspace:
    case parameter::kLargestWorkspace:
      std::copy_n(f.model->usable_mm, 6, out.begin());
      break;
    case parameter::kTabletopOffset:
      out[0] = f.model->usable_mm[1];
      break;
    case parameter::kMaxStiffness:
      out[0] = f.model->stiffness_n_per_mm;
      break;
    case parameter::kMaxForce:
      out[0] = f.model->max_force_n;
      break;
    case parameter::kMaxContinuousForce:
      out[0] = f.model->continuous_force_n;
      break;
    case parameter::kMaxDamping:
      out[0] = f.model->damping_n_s_per_mm;
      break;
    case parameter::kMotorTemperature:
      out = {0.5 * f.temperature, f.temperature, 0.25 * f.temperature};
      break;
    case parameter::kForce:
      std::copy(f.asked.begin(), f.asked.end(), out.begin());
      break;
    default:
      break;
  }
  return out;
}

int integer(hd::Enum what) {
  const Fake& f = fake();
  switch (what) {
    case parameter::kButtons:
      return static_cast<int>(f.frame.pen.buttons);
    case parameter::kInputDof:
      return 6;
    case parameter::kOutputDof:
      return 3;
    case parameter::kCalibrationStyle:
      return f.model->calibration_style;
    case parameter::kUpdateRate:
    case parameter::kMeasuredUpdateRate:
      return f.model->rate_hz;
    default:
      return 0;
  }
}

}  // namespace felt::fake_libhd
