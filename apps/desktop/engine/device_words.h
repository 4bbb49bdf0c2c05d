#pragma once

#include <QString>

#include "felt/driver/driver.h"

namespace felt::desktop {

/// A device fault in words for the user.
struct DeviceWords {
  QString what;     ///< what happened: one sentence
  QString to_do;    ///< how the user can continue, and what to do about the fault
  QString details;  ///< the vendor's own message and number; may be empty
};

/// Describes a fault. `device` is the name of the device. `draws` is true if the device's pen can
/// still be read, so that the user can continue to draw with that pen.
DeviceWords words_for(DeviceFault fault, const QString& device, const DeviceStatus& status,
                      bool draws);

/// Describes a fault in half a sentence: "the device is no longer connected".
QString words_for(DeviceFault fault);

/// Returns the vendor's own message and number, so that the user can search for them. Empty if the
/// vendor gave neither.
QString vendor_words(const DeviceStatus& status);

}  // namespace felt::desktop
