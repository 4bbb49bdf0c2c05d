#pragma once

#include <memory>
#include <optional>
#include <string>

#include "felt/driver/driver.h"

namespace felt {

struct ForceDimensionOptions {
  /// File of the library; empty: $FELT_FORCEDIMENSION_LIBRARY, else it is looked for.
  std::string library;
  /// Mass of what is screwed onto the device in the place of its own end, a pen, kg, 0..0.5: the
  /// library bears that weight. Nothing: $FELT_FORCEDIMENSION_PEN_KG, else what the maker expects.
  std::optional<double> pen_mass_kg;
};

/// Force Dimension's omega, delta, sigma and lambda, and the Novint Falcon, through Force
/// Dimension's own library (SDK 3, libdrd.so or libdhd.so), which is loaded when a device is looked
/// for. docs/devices/forcedimension.md; README.md here says how the library is used.
std::unique_ptr<Driver> make_forcedimension_driver(ForceDimensionOptions options = {});

}  // namespace felt
