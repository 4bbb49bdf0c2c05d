#pragma once

#include <QObject>
#include <QString>
#include <QVariant>

namespace felt::desktop {

/// The user's settings, kept in the XDG configuration folder: one flat table, "pens/pressure_curve"
/// -> value. Each folder names its own keys, with their defaults, in its own header. Reading is
/// cheap (a table in memory).
///
/// One per process, made before the first window; qApp's thread.
class Settings : public QObject {
  Q_OBJECT

 public:
  static Settings& the();

  [[nodiscard]] QVariant value(const QString& key, const QVariant& fallback = {}) const;
  [[nodiscard]] double number(const QString& key, double fallback) const;
  [[nodiscard]] bool flag(const QString& key, bool fallback) const;
  [[nodiscard]] QString text(const QString& key, const QString& fallback = {}) const;
  /// Sets a value. It is stored soon after; `changed` is emitted immediately, and only if the value
  /// differs.
  void set(const QString& key, const QVariant& value);
  /// Removes the user's value, so that the default applies. `changed` is emitted if there was one.
  void reset(const QString& key);

 Q_SIGNALS:
  void changed(const QString& key);

 private:
  Settings() = default;
};

}  // namespace felt::desktop
