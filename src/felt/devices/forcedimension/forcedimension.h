#pragma once

#include <memory>
#include <optional>
#include <string>

#include "felt/driver/driver.h"

namespace felt {

struct ForceDimensionOptions {
  /// The file of the library. If empty, $FELT_FORCEDIMENSION_LIBRARY is used if set; otherwise the
  /// library is searched.
  std::string library;
  /// Mass of a part, such as a pen, that replaces the device's own end, kg, 0..0.5. The library
  /// compensates its weight. If nullopt, $FELT_FORCEDIMENSION_PEN_KG is used if set, and otherwise
  /// the maker's assumption.
  std::optional<double> pen_mass_kg;
};

/// Makes the driver of Force Dimension's omega, delta, sigma and lambda, and of the Novint Falcon.
/// It uses Force Dimension's own library (SDK 3, libdrd.so or libdhd.so), which is loaded when
/// devices are searched. docs/devices/forcedimension.md; the README.md here says how the library is
/// used.
std::unique_ptr<Driver> make_forcedimension_driver(ForceDimensionOptions options = {});

}  // namespace felt
