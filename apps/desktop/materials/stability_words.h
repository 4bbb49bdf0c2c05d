#pragma once

#include <QString>

#include "desktop/materials/felt_probe.h"

namespace felt::desktop {

/// Whether a device can give what a material wishes.
enum class StabilityLevel {
  kGiven,    ///< as wished, and quiet
  kLess,     ///< less than wished, or close to what can be felt as trembling
  kNotGiven  ///< less than half of it, or it trembles
};

/// It, for a person: a word, a number, and what is not as wished.
struct StabilityWords {
  StabilityLevel level = StabilityLevel::kGiven;
  QString state;       ///< "Stable", "Limited by the device", "Trembles"
  QString number;      ///< "67 % of what the device bears"
  QStringList detail;  ///< sentences; none where all is as wished
};

/// `device_label`: "3D Systems Touch".
StabilityWords stability_words(const FeltWish& wish, const FeltFigures& figures,
                               const QString& device_label);

}  // namespace felt::desktop
