#include "desktop/engine/device_words.h"

#include <QCoreApplication>

namespace felt::desktop {
namespace {

QString device_text(const char* text) {
  return QCoreApplication::translate("DeviceWords", text);
}

}  // namespace

QString vendor_words(const DeviceStatus& status) {
  const std::string_view said = status.vendor_words.view();
  QString text = QString::fromUtf8(said.data(), qsizetype(said.size())).trimmed();
  if (status.vendor_code != 0) {
    const QString code = QString::number(status.vendor_code);
    text = text.isEmpty() ? code : QStringLiteral("%1 (%2)").arg(text, code);
  }
  return text;
}

QString words_for(DeviceFault fault) {
  switch (fault) {
    case DeviceFault::kDisconnected:
      return device_text(QT_TRANSLATE_NOOP("DeviceWords", "the device is no longer connected"));
    case DeviceFault::kNotCalibrated:
      return device_text(
          QT_TRANSLATE_NOOP("DeviceWords", "the device does not know the position of its arm"));
    case DeviceFault::kForcesOff:
      return device_text(
          QT_TRANSLATE_NOOP("DeviceWords", "the device has switched its forces off"));
    case DeviceFault::kOverheated:
      return device_text(QT_TRANSLATE_NOOP("DeviceWords", "its motors are too warm"));
    case DeviceFault::kBadData:
      return device_text(QT_TRANSLATE_NOOP("DeviceWords", "the device reports impossible values"));
    case DeviceFault::kOther:
      return device_text(QT_TRANSLATE_NOOP("DeviceWords", "the device reports a fault"));
  }
  return {};
}

DeviceWords words_for(DeviceFault fault, const QString& device, const DeviceStatus& status,
                      bool draws) {
  DeviceWords words;
  words.details = vendor_words(status);
  switch (fault) {
    case DeviceFault::kDisconnected:
      words.what = device_text(QT_TRANSLATE_NOOP("DeviceWords", "%1 is no longer connected."));
      words.to_do = device_text(QT_TRANSLATE_NOOP(
          "DeviceWords",
          "Nothing is lost. Check its cable and power; you can continue with mouse or tablet."));
      break;
    case DeviceFault::kNotCalibrated:
      words.what = device_text(
          QT_TRANSLATE_NOOP("DeviceWords", "%1 does not know the position of its arm."));
      words.to_do = device_text(QT_TRANSLATE_NOOP(
          "DeviceWords", "Until it has found its home position, continue with mouse or tablet."));
      break;
    case DeviceFault::kForcesOff:
      words.what = device_text(QT_TRANSLATE_NOOP("DeviceWords", "%1 has switched its forces off."));
      words.to_do = device_text(
          QT_TRANSLATE_NOOP("DeviceWords",
                            "Its switch or its own protection did this. Continue without forces, "
                            "or switch them on at the device and then here."));
      break;
    case DeviceFault::kOverheated:
      words.what = device_text(QT_TRANSLATE_NOOP("DeviceWords", "The motors of %1 are too warm."));
      words.to_do = device_text(QT_TRANSLATE_NOOP(
          "DeviceWords",
          "Continue without forces. You can switch them on again in a few minutes."));
      break;
    case DeviceFault::kBadData:
    case DeviceFault::kOther:
      words.what =
          fault == DeviceFault::kBadData
              ? device_text(QT_TRANSLATE_NOOP("DeviceWords", "%1 reports impossible values."))
              : device_text(QT_TRANSLATE_NOOP("DeviceWords", "%1 reports a fault."));
      words.to_do =
          draws ? device_text(QT_TRANSLATE_NOOP("DeviceWords", "Continue without forces."))
                : device_text(QT_TRANSLATE_NOOP("DeviceWords",
                                                "Continue with mouse or tablet. Check the cable, "
                                                "switch the device off and on, and try again."));
      break;
  }
  words.what = words.what.arg(device);
  return words;
}

}  // namespace felt::desktop
