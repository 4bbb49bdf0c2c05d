#pragma once

#include <memory>
#include <optional>
#include <string>

#include "felt/driver/driver.h"

namespace felt {

struct ForceDimensionOptions {
  /// The file of the library. If it is empty, $FELT_FORCEDIMENSION_LIBRARY is used; if that is not
  /// set, the names of library_names() are tried.
  std::string library;
  /// Mass in kg (0..0.5) of a part such as a pen that is mounted in place of the device's own
  /// handle. The library compensates the weight of this part. If it is nullopt,
  /// $FELT_FORCEDIMENSION_PEN_KG is used; if that is not set, the maker's default mass is used.
  std::optional<double> pen_mass_kg;
};

/// Makes the driver of Force Dimension's omega, delta, sigma and lambda, and of the Novint Falcon.
/// It uses Force Dimension's own library (SDK 3, libdrd.so or libdhd.so), which is loaded when
/// devices are searched. See docs/devices/forcedimension.md for users, and the README.md in this
/// folder for the use of the library.
std::unique_ptr<Driver> make_forcedimension_driver(ForceDimensionOptions options = {});

}  // namespace felt
