#pragma once

#include "desktop/engine/studio.h"

namespace felt::desktop {

/// Returns options of a studio whose haptic loop does not advance by itself: the test advances it.
inline StudioOptions by_hand() {
  StudioOptions options;
  options.live = false;
  return options;
}

}  // namespace felt::desktop
