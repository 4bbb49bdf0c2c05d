#pragma once

#include <QPointingDevice>
#include <QTabletEvent>
#include <optional>

#include "felt/geometry/tilt.h"

namespace felt::desktop {

/// Returns the angle between the pen and the surface normal, in degrees, rounded to a tenth;
/// nullopt if the pen does not sense its tilt. Qt reports the angles of the pen's projections on
/// two planes, usually -60..60: +x to the right, +y towards the user. The rotation of the page on
/// the screen does not matter.
inline std::optional<double> tilt_of(const QTabletEvent& event) {
  using Capability = QInputDevice::Capability;
  const QPointingDevice* device = event.pointingDevice();
  if (!device || !device->hasCapability(Capability::XTilt) ||
      !device->hasCapability(Capability::YTilt)) {
    return std::nullopt;
  }
  return tilt_of_xy(event.xTilt(), event.yTilt());
}

}  // namespace felt::desktop
