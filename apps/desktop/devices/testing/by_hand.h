#pragma once

#include "desktop/engine/studio.h"

namespace felt::desktop {

/// Returns options of a studio whose haptic loop does nothing by itself: the test runs it.
inline StudioOptions by_hand() {
  StudioOptions options;
  options.live = false;
  return options;
}

}  // namespace felt::desktop
