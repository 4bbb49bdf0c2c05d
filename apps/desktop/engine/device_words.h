#pragma once

#include <QString>

#include "felt/driver/driver.h"

namespace felt::desktop {

/// What a fault of a device means, for people.
struct DeviceWords {
  QString what;     ///< what happened: one sentence
  QString to_do;    ///< what goes on without them, and what they can do
  QString details;  ///< the maker's own words and number; may be empty
};

/// `device` is its name; `draws`: its pen can be read, so that one can draw on with it.
DeviceWords words_for(DeviceFault fault, const QString& device, const DeviceStatus& status,
                      bool draws);

/// The same as half a sentence: "the device is not connected any more".
QString words_for(DeviceFault fault);

/// The maker's own words and number, for those who look for them elsewhere. Empty: it said none.
QString vendor_words(const DeviceStatus& status);

}  // namespace felt::desktop
