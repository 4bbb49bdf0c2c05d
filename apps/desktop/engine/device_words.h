#pragma once

#include <QString>

#include "felt/driver/driver.h"

namespace felt::desktop {

/// A device fault in words for the user.
struct DeviceWords {
  QString what;     ///< what happened: one sentence
  QString to_do;    ///< how the session continues, and what the user can do
  QString details;  ///< the vendor's own message and number; may be empty
};

/// Describes a fault. `device` is its name; `draws` is true if its pen can still be read, so that
/// the user can go on drawing with it.
DeviceWords words_for(DeviceFault fault, const QString& device, const DeviceStatus& status,
                      bool draws);

/// Describes it in half a sentence: "the device is no longer connected".
QString words_for(DeviceFault fault);

/// Returns the vendor's own message and number, so that the user can search for them. Empty if
/// there are none.
QString vendor_words(const DeviceStatus& status);

}  // namespace felt::desktop
