#pragma once

#include <QString>

#include "desktop/materials/felt_probe.h"

namespace felt::desktop {

/// How well a device can render a material.
enum class StabilityLevel {
  kGiven,    ///< completely and without trembling
  kLess,     ///< with reduced values, or close to a perceptible tremble
  kNotGiven  ///< less than half of the wanted values, or it trembles
};

/// The stability in words: a state, a number, and the deviations.
struct StabilityWords {
  StabilityLevel level = StabilityLevel::kGiven;
  QString state;       ///< "Stable", "Limited by the device", "Trembles"
  QString number;      ///< "67 % of what the device bears"
  QStringList detail;  ///< sentences; empty if nothing deviates
};

/// Describes the stability. An example of `device_label` is "3D Systems Touch".
StabilityWords stability_words(const FeltWish& wish, const FeltFigures& figures,
                               const QString& device_label);

}  // namespace felt::desktop
