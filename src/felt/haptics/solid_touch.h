#pragma once

#include <cstdint>

#include "felt/geometry/surface_proxy.h"
#include "felt/haptics/pen_sample.h"

namespace felt {

/// The point that bodies keep outside, and which bodies do so (SolidSurface). Trivially copyable.
struct SolidTouch {
  SurfaceProxy proxy{};
  Vec3 pen_mm{};             ///< at the last tick
  VelocityFilter motion{};   ///< of the pen, from its positions
  std::int64_t time_ns = 0;  ///< of the last tick
  double repeated_s = 0.0;   ///< time for which the device has repeated its sample
  std::uint32_t number = 0;  ///< SolidSurfaceOptions::number; 0: none
  /// The proxy follows the pen; false until the pen has been in front of the body.
  bool is_outside = false;
  double friction_factor = 1.0;  ///< of the grain, at the last tick
};

}  // namespace felt
