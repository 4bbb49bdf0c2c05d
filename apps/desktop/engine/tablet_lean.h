#pragma once

#include <QPointingDevice>
#include <QTabletEvent>
#include <optional>

#include "felt/geometry/lean.h"

namespace felt::desktop {

/// How far the pen leans from the upright, degrees, in tenths; none of a pen that does not sense
/// it. Qt's angles are those of the pen's shadows, -60..60 as a rule: +x to the right, +y towards
/// the person. How the sheet is turned on the screen changes nothing.
inline std::optional<double> lean_of(const QTabletEvent& event) {
  using Capability = QInputDevice::Capability;
  const QPointingDevice* device = event.pointingDevice();
  if (!device || !device->hasCapability(Capability::XTilt) ||
      !device->hasCapability(Capability::YTilt)) {
    return std::nullopt;
  }
  return lean_of_tilt(event.xTilt(), event.yTilt());
}

}  // namespace felt::desktop
