#pragma once

#include <memory>
#include <optional>
#include <string>

#include "felt/driver/driver.h"

namespace felt {

struct ForceDimensionOptions {
  /// File of the library; empty: $FELT_FORCEDIMENSION_LIBRARY, or else a search.
  std::string library;
  /// Mass of the part, such as a pen, that is mounted in place of the device's own end, kg, 0..0.5;
  /// the library compensates this weight. Unset: $FELT_FORCEDIMENSION_PEN_KG, or else the maker's
  /// assumption.
  std::optional<double> pen_mass_kg;
};

/// Makes the driver of Force Dimension's omega, delta, sigma and lambda, and of the Novint Falcon.
/// It uses Force Dimension's own library (SDK 3, libdrd.so or libdhd.so), which is loaded when
/// devices are searched. docs/devices/forcedimension.md; the README.md here says how the library is
/// used.
std::unique_ptr<Driver> make_forcedimension_driver(ForceDimensionOptions options = {});

}  // namespace felt
