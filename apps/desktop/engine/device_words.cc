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
      return device_text(QT_TRANSLATE_NOOP("DeviceWords", "the device is not connected any more"));
    case DeviceFault::kNotCalibrated:
      return device_text(
          QT_TRANSLATE_NOOP("DeviceWords", "the device does not know where its arm is"));
    case DeviceFault::kForcesOff:
      return device_text(
          QT_TRANSLATE_NOOP("DeviceWords", "the device has switched its forces off"));
    case DeviceFault::kOverheated:
      return device_text(QT_TRANSLATE_NOOP("DeviceWords", "its motors are warm"));
    case DeviceFault::kBadData:
      return device_text(QT_TRANSLATE_NOOP("DeviceWords", "the device says what cannot be"));
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
      words.what = device_text(QT_TRANSLATE_NOOP("DeviceWords", "%1 is not connected any more."));
      words.to_do = device_text(QT_TRANSLATE_NOOP(
          "DeviceWords",
          "Draw on with mouse or tablet; nothing is lost. Look at its cable and its power."));
      break;
    case DeviceFault::kNotCalibrated:
      words.what =
          device_text(QT_TRANSLATE_NOOP("DeviceWords", "%1 does not know where its arm is."));
      words.to_do = device_text(QT_TRANSLATE_NOOP(
          "DeviceWords", "Draw on with mouse or tablet until it has found its home."));
      break;
    case DeviceFault::kForcesOff:
      words.what = device_text(QT_TRANSLATE_NOOP("DeviceWords", "%1 has switched its forces off."));
      words.to_do = device_text(QT_TRANSLATE_NOOP(
          "DeviceWords",
          "Its button or its own guard did that. Draw on without forces, or switch them on again "
          "there and here."));
      break;
    case DeviceFault::kOverheated:
      words.what = device_text(QT_TRANSLATE_NOOP("DeviceWords", "The motors of %1 are warm."));
      words.to_do = device_text(QT_TRANSLATE_NOOP(
          "DeviceWords",
          "Draw on without forces. After some minutes of rest they can be switched on again."));
      break;
    case DeviceFault::kBadData:
    case DeviceFault::kOther:
      words.what = fault == DeviceFault::kBadData
                       ? device_text(QT_TRANSLATE_NOOP("DeviceWords", "%1 says what cannot be."))
                       : device_text(QT_TRANSLATE_NOOP("DeviceWords", "%1 reports a fault."));
      words.to_do = draws ? device_text(QT_TRANSLATE_NOOP("DeviceWords", "Draw on without forces."))
                          : device_text(QT_TRANSLATE_NOOP(
                                "DeviceWords",
                                "Draw on with mouse or tablet. Look at its cable, switch "
                                "it off and on, and try again."));
      break;
  }
  words.what = words.what.arg(device);
  return words;
}

}  // namespace felt::desktop
