#include "desktop/materials/stability_words.h"

#include <QCoreApplication>
#include <QLocale>
#include <algorithm>

namespace felt::desktop {
namespace {

constexpr double kFeltN = 0.04;   // smallest perceived change (docs/design/simulation.md)
constexpr double kCleanN = 0.03;  // below this value the tremble is "clean"
                                  // (docs/design/limits.md)
constexpr double kWhole = 0.95;   // from this share of the wanted value on, the difference is not
                                  // felt
constexpr double kHalf = 0.5;

QString text(const char* english) {
  return QCoreApplication::translate("Stability", english);
}

QString whole(double number) {
  return QLocale().toString(number, 'f', 0);
}

/// Returns a height in micrometres. A large height has no decimals, because they cannot be felt.
QString height(double um) {
  return QLocale().toString(um, 'f', um < 10.0 ? 1 : 0);
}

StabilityLevel level_of_share(double share) {
  if (share >= kWhole) return StabilityLevel::kGiven;
  return share >= kHalf ? StabilityLevel::kLess : StabilityLevel::kNotGiven;
}

StabilityLevel level_of_rest(const ProbeFigures& figures) {
  if (!figures.is_sound || figures.rest_n >= kFeltN) return StabilityLevel::kNotGiven;
  return figures.rest_n >= kCleanN ? StabilityLevel::kLess : StabilityLevel::kGiven;
}

QString state_of(StabilityLevel level, bool trembles) {
  if (level == StabilityLevel::kGiven) {
    return text(QT_TRANSLATE_NOOP("Stability", "Stable, as requested"));
  }
  if (trembles) {
    return level == StabilityLevel::kLess
               ? text(QT_TRANSLATE_NOOP("Stability", "Close to trembling"))
               : text(QT_TRANSLATE_NOOP("Stability", "Trembles"));
  }
  return level == StabilityLevel::kLess
             ? text(QT_TRANSLATE_NOOP("Stability", "Stable, but less than requested"))
             : text(QT_TRANSLATE_NOOP("Stability", "Too much for this device"));
}

void report_rest(const ProbeFigures& figures, QStringList& detail) {
  if (!figures.is_sound) {
    detail << text(QT_TRANSLATE_NOOP("Stability", "The safety chain would switch forces off."));
  }
  if (figures.rest_n < kCleanN) return;
  detail << text(QT_TRANSLATE_NOOP("Stability",
                                   "The pen at rest trembles with %1 N above 30 Hz; 0.04 N can be "
                                   "felt. Reduce hardness or friction, or add damping."))
                .arg(QLocale().toString(figures.rest_n, 'f', 3));
}

}  // namespace

StabilityWords stability_words(const ProbeRequest& request, const ProbeFigures& figures,
                               const QString& device_label) {
  StabilityWords words;
  if (!request.device.has_force()) {
    words.detail << text(QT_TRANSLATE_NOOP("Stability",
                                           "%1 has no motors, so nothing is felt. The figures are "
                                           "those of a 3D Systems Touch."))
                        .arg(device_label);
  }
  const double hard = figures.stiffness_n_per_m / request.surface.stiffness_n_per_m;
  const StabilityLevel rest = level_of_rest(figures);
  words.level = std::max({level_of_share(hard), level_of_share(figures.grain_share), rest});
  words.state = state_of(words.level, rest == words.level);
  words.number = text(QT_TRANSLATE_NOOP("Stability", "%1 % of the device’s limit"))
                     .arg(whole(100.0 * figures.budget_share));
  if (hard < kWhole) {
    words.detail << text(QT_TRANSLATE_NOOP("Stability",
                                           "Hardness: this device reaches %1 of your %2 N/m."))
                        .arg(whole(figures.stiffness_n_per_m),
                             whole(request.surface.stiffness_n_per_m));
  }
  if (figures.grain_share < kWhole) {
    words.detail
        << text(QT_TRANSLATE_NOOP(
                    "Stability",
                    "Grain: it is too steep for the haptic loop; you feel %1 of your %2 µm."))
               .arg(height(figures.grain_share * request.surface.grain_um),
                    height(request.surface.grain_um));
  }
  report_rest(figures, words.detail);
  return words;
}

}  // namespace felt::desktop
