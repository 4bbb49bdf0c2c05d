#pragma once

#include <cstddef>

#include "felt/tools/overlay.h"

namespace felt {

/// The appearance of a role, the same on the canvas and in pictures.
struct RoleLook {
  std::size_t color = 6;  ///< index into the colour-blind-safe palette (plot_color)
  bool dashed = false;    ///< for bounds and hints
  double width = 1.3;     ///< line width, in picture units or device-independent pixels
  bool has_halo = true;   ///< on the canvas: a light or dark seam, so that it shows on any ink
};

constexpr RoleLook look_of(Overlay::Role role) noexcept {
  using Role = Overlay::Role;
  switch (role) {
    case Role::kReach:
      return {2, true, 1.3};  // bluish green
    case Role::kSnap:
      return {0, false, 1.9};  // blue
    case Role::kTether:
      return {1, true, 1.3};  // vermillion
    case Role::kGuide:
      return {6, true, 1.3};  // grey
    case Role::kSpan:
      return {5, false, 1.3};  // sky blue
    case Role::kVector:
      return {4, false, 2.4};  // orange
    case Role::kSelected:
      return {0, true, 1.3};  // blue
    case Role::kHandle:
      return {3, false, 1.3};  // reddish purple
    case Role::kCut:
      return {1, false, 1.9};  // vermillion
    case Role::kRule:
      return {5, false, 1.1, false};  // sky blue
    case Role::kTick:
      return {5, false, 0.6, false};  // sky blue
    case Role::kAxis:
      return {4, true, 1.1, false};  // orange
  }
  return {};
}

}  // namespace felt
