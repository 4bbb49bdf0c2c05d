#pragma once

#include <QObject>
#include <QString>
#include <QVariant>

namespace felt::desktop {

/// The user's settings, stored in the XDG configuration folder as one flat table,
/// "pens/pressure_curve" -> value. Each source folder defines its own keys and their defaults in a
/// header. Reading is cheap because the table is in memory.
///
/// Each process has one Settings object, which is made before the first window. Use it in qApp's
/// thread.
class Settings : public QObject {
  Q_OBJECT

 public:
  static Settings& the();

  [[nodiscard]] QVariant value(const QString& key, const QVariant& fallback = {}) const;
  [[nodiscard]] double number(const QString& key, double fallback) const;
  [[nodiscard]] bool flag(const QString& key, bool fallback) const;
  [[nodiscard]] QString text(const QString& key, const QString& fallback = {}) const;
  /// Sets a value, which is written to the disk soon afterwards. Emits `changed` immediately if the
  /// value differs from the previous value.
  void set(const QString& key, const QVariant& value);
  /// Removes the user's value, so that the default applies. Emits `changed` if a value was set.
  void reset(const QString& key);

 Q_SIGNALS:
  void changed(const QString& key);

 private:
  Settings() = default;
};

}  // namespace felt::desktop
