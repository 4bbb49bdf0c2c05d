#include "desktop/feel/safety_words.h"

#include <QCoreApplication>
#include <QStringList>
#include <array>
#include <cstring>

#include "desktop/engine/device_words.h"

namespace felt::desktop {
namespace {

/// Returns a text that says which limits reduce the force now.
QString limits_in_words(std::uint32_t limited_by) {
  struct Stage {
    SafetyStage bit;
    const char* words;
  };
  static constexpr std::array<Stage, 5> kStages{{
      {kLimitedByPeak, QT_TRANSLATE_NOOP("SafetyWords", "the force limit")},
      {kLimitedByContinuous,
       QT_TRANSLATE_NOOP("SafetyWords", "the continuous force of the motors")},
      {kLimitedBySpeed, QT_TRANSLATE_NOOP("SafetyWords", "the speed of the pen")},
      {kLimitedByRise, QT_TRANSLATE_NOOP("SafetyWords", "the limit on how fast a force may rise")},
      {kLimitedByBudget, QT_TRANSLATE_NOOP("SafetyWords", "the largest stiffness of the device")},
  }};
  QStringList words;
  for (const Stage& stage : kStages) {
    if (limited_by & stage.bit)
      words.push_back(QCoreApplication::translate("SafetyWords", stage.words));
  }
  return words.isEmpty() ? QString()
                         : QCoreApplication::translate("SafetyWords", "Limited by %1.")
                               .arg(words.join(QCoreApplication::translate("SafetyWords", ", ")));
}

SafetyWords active(const SafetyReport& safety) {
  const QString limits = limits_in_words(safety.limited_by);
  return {limits.isEmpty() ? FeelLevel::kOn : FeelLevel::kLimited,
          QCoreApplication::translate("SafetyWords", "Forces are on"), limits};
}

SafetyWords latched(const SafetyReport& safety, std::optional<DeviceFault> device) {
  const bool is_of_device = safety.fault == SafetyFault::kDeviceError && device;
  const QString why = is_of_device ? words_for(*device) : words_for(safety.fault);
  const QString state =
      why.isEmpty()
          ? QCoreApplication::translate("SafetyWords", "Forces were stopped")
          : QCoreApplication::translate("SafetyWords", "Forces were stopped: %1").arg(why);
  if (is_of_device && *device == DeviceFault::kForcesOff) {
    return {FeelLevel::kStopped, state,
            QCoreApplication::translate("SafetyWords",
                                        "You can continue to draw. Switch the forces on at the "
                                        "device, lift the pen, then switch them on here.")};
  }
  if (is_of_device && *device == DeviceFault::kOverheated) {
    return {FeelLevel::kStopped, state,
            QCoreApplication::translate("SafetyWords",
                                        "You can continue to draw. Let the device rest for a few "
                                        "minutes, then switch the forces on again.")};
  }
  if (safety.fault == SafetyFault::kDeviceError) {
    return {FeelLevel::kStopped, state,
            QCoreApplication::translate(
                "SafetyWords",
                "Check the cable and the power of the device, then switch the forces on again.")};
  }
  return {
      FeelLevel::kStopped, state,
      QCoreApplication::translate(
          "SafetyWords", "You can continue to draw. Lift the pen and switch the forces on again.")};
}

}  // namespace

QString words_for(SafetyFault fault) {
  switch (fault) {
    case SafetyFault::kNone:
      return {};
    case SafetyFault::kLateTick:
      return QCoreApplication::translate("SafetyWords", "the computer was too busy");
    case SafetyFault::kTooFast:
      return QCoreApplication::translate("SafetyWords", "the pen was too fast");
    case SafetyFault::kEditSilent:
      return QCoreApplication::translate("SafetyWords", "the program was too busy");
    case SafetyFault::kVeryLateTick:
      return QCoreApplication::translate("SafetyWords", "the computer paused for a moment");
    case SafetyFault::kNotFinite:
      return QCoreApplication::translate("SafetyWords", "a force was invalid");
    case SafetyFault::kDeviceError:
      return QCoreApplication::translate("SafetyWords", "the device does not answer");
    case SafetyFault::kPositionJump:
      return QCoreApplication::translate("SafetyWords", "the pen seemed to jump");
    case SafetyFault::kTooManyFaults:
      return QCoreApplication::translate(
          "SafetyWords", "the computer or the device could not keep up several times in a minute");
    case SafetyFault::kSelfTest:
      return QCoreApplication::translate("SafetyWords", "the self-test failed");
  }
  return {};
}

SafetyWords words_for(const SafetyReport& safety, bool has_motors, bool wanted,
                      std::optional<DeviceFault> device) {
  if (!has_motors) {
    if (!wanted)
      return {FeelLevel::kOff, QCoreApplication::translate("SafetyWords", "Forces are off"),
              QCoreApplication::translate("SafetyWords", "They are not shown either.")};
    return {FeelLevel::kShown,
            QCoreApplication::translate("SafetyWords", "Shown, not felt: this pen has no motors"),
            QCoreApplication::translate(
                "SafetyWords", "The plot shows the forces that a device would be asked for.")};
  }
  switch (safety.state) {
    case SafetyState::kOff:
      return {FeelLevel::kOff, QCoreApplication::translate("SafetyWords", "Forces are off"), {}};
    case SafetyState::kWaiting:
      return {FeelLevel::kWaiting, QCoreApplication::translate("SafetyWords", "Ready"),
              QCoreApplication::translate("SafetyWords",
                                          "Lift the pen for a moment to start the forces.")};
    case SafetyState::kEngaging:
      return {FeelLevel::kWaiting,
              QCoreApplication::translate("SafetyWords", "Forces are starting"),
              {}};
    case SafetyState::kActive:
      return active(safety);
    case SafetyState::kSilent:
      return {FeelLevel::kLimited,
              QCoreApplication::translate("SafetyWords", "The program is busy"),
              QCoreApplication::translate("SafetyWords", "The pen only feels damping.")};
    case SafetyState::kFalling:
      return {FeelLevel::kLimited,
              QCoreApplication::translate("SafetyWords", "Forces are reduced: %1")
                  .arg(words_for(safety.fault)),
              QCoreApplication::translate("SafetyWords", "They return by themselves.")};
    case SafetyState::kLatched:
      return latched(safety, device);
  }
  return {};
}

QString term_label(const char* name) {
  struct Label {
    const char* name;
    const char* label;
  };
  static constexpr std::array<Label, 13> kLabels{{
      {"asked", QT_TRANSLATE_NOOP("SafetyWords", "Sum, requested")},
      {"sent", QT_TRANSLATE_NOOP("SafetyWords", "Sent to the pen")},
      {"plane", QT_TRANSLATE_NOOP("SafetyWords", "Surface")},
      {"friction", QT_TRANSLATE_NOOP("SafetyWords", "Friction")},
      {"viscosity", QT_TRANSLATE_NOOP("SafetyWords", "Viscosity")},
      {"texture", QT_TRANSLATE_NOOP("SafetyWords", "Grain")},
      {"edit", QT_TRANSLATE_NOOP("SafetyWords", "Curve")},
      {"snap", QT_TRANSLATE_NOOP("SafetyWords", "Snap")},
      {"tether", QT_TRANSLATE_NOOP("SafetyWords", "Tether")},
      {"stabiliser", QT_TRANSLATE_NOOP("SafetyWords", "Stabiliser")},
      {"stop", QT_TRANSLATE_NOOP("SafetyWords", "Stop")},
      {"damping", QT_TRANSLATE_NOOP("SafetyWords", "Damping")},
      {"other", QT_TRANSLATE_NOOP("SafetyWords", "Other")},
  }};
  for (const Label& label : kLabels) {
    if (std::strcmp(label.name, name) == 0)
      return QCoreApplication::translate("SafetyWords", label.label);
  }
  return QString::fromUtf8(name);
}

}  // namespace felt::desktop
