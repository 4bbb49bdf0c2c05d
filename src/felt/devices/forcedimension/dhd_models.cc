#include "felt/devices/forcedimension/dhd_models.h"

#include <array>

namespace felt::dhd {
namespace {

constexpr ForceCall kGripper = ForceCall::kForceAndGripper;
constexpr ForceCall kAll = ForceCall::kForceTorqueAndGripper;

// The numbers come from dhdc.h of SDK 3.17; 110 and 111 come from CHAI3D.
constexpr std::array kTypes{
    SystemType{33, "omega.3", "Force Dimension omega.3"},
    SystemType{34, "omega.6", "Force Dimension omega.6"},
    SystemType{36, "omega.6", "Force Dimension omega.6, left-handed"},
    SystemType{35, "omega.7", "Force Dimension omega.7", kGripper},
    SystemType{37, "omega.7", "Force Dimension omega.7, left-handed", kGripper},
    SystemType{60, "falcon", "Novint Falcon"},
    SystemType{63, "delta.3", "Force Dimension delta.3"},
    SystemType{104, "sigma.7", "Force Dimension sigma.7", kAll},
    SystemType{105, "sigma.7", "Force Dimension sigma.7, left-handed", kAll},
    SystemType{108, "lambda.7", "Force Dimension lambda.7", kAll},
    SystemType{109, "lambda.7", "Force Dimension lambda.7, left-handed", kAll},
    SystemType{110, "omega.3", "Force Dimension omega.3", ForceCall::kForce, true},
    SystemType{111, "delta.3", "Force Dimension delta.3"},
    SystemType{131, "lambda.6", "Force Dimension lambda.6"},
    SystemType{132, "lambda.6", "Force Dimension lambda.6, left-handed"},
    SystemType{203, "lambda.3", "Force Dimension lambda.3"},
    SystemType{206, "sigma.3", "Force Dimension sigma.3"},
};

}  // namespace

SystemType system_type_of(int number) noexcept {
  for (const SystemType& type : kTypes) {
    if (type.number == number) return type;
  }
  return {number, "generic-3dof", ""};
}

}  // namespace felt::dhd
