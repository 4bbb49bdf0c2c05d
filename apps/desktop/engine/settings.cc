#include "desktop/engine/settings.h"

#include <QSettings>

namespace felt::desktop {
namespace {

QSettings& store() {
  static QSettings settings;
  return settings;
}

}  // namespace

Settings& Settings::the() {
  static Settings settings;
  return settings;
}

QVariant Settings::value(const QString& key, const QVariant& fallback) const {
  return store().value(key, fallback);
}

double Settings::number(const QString& key, double fallback) const {
  bool ok = false;
  const double number = value(key).toDouble(&ok);
  return ok ? number : fallback;
}

bool Settings::flag(const QString& key, bool fallback) const {
  return value(key, fallback).toBool();
}

QString Settings::text(const QString& key, const QString& fallback) const {
  return value(key, fallback).toString();
}

void Settings::set(const QString& key, const QVariant& value) {
  if (store().value(key) == value) return;
  store().setValue(key, value);
  Q_EMIT changed(key);
}

void Settings::reset(const QString& key) {
  if (!store().contains(key)) return;
  store().remove(key);
  Q_EMIT changed(key);
}

}  // namespace felt::desktop
