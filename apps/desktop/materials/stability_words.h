#pragma once

#include <QString>

#include "desktop/materials/force_probe.h"

namespace felt::desktop {

/// How well a device can render a material.
enum class StabilityLevel {
  kGiven,    ///< the device renders the material completely and without trembling
  kLess,     ///< some values are reduced, or the tremble is almost perceptible
  kNotGiven  ///< a value is less than half of the requested value, the pen trembles, or the safety
             ///< chain reports a fault
};

/// The stability in words: a state, a number, and the deviations.
struct StabilityWords {
  StabilityLevel level = StabilityLevel::kGiven;
  QString state;       ///< "Stable, as requested", "Too much for this device"
  QString number;      ///< "67 % of the device’s limit"
  QStringList detail;  ///< sentences; empty if nothing deviates
};

/// Describes the stability. An example of `device_label` is "3D Systems Touch".
StabilityWords stability_words(const ProbeRequest& request, const ProbeFigures& figures,
                               const QString& device_label);

}  // namespace felt::desktop
