#pragma once

#include <QObject>
#include <QString>
#include <QVariant>

namespace felt::desktop {

/// What a person has chosen for the program, kept in the XDG configuration folder from one start to
/// the next: one flat table, "pens/pressure_curve" -> value. Each room names its own keys, in a
/// header of its own, with their defaults. Reading is cheap (a table in memory).
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
  /// Stored soon after; `changed` comes at once, and only where the value differs.
  void set(const QString& key, const QVariant& value);
  /// Forgets what was chosen, so that the default counts; `changed` comes where there was
  /// something.
  void reset(const QString& key);

 Q_SIGNALS:
  void changed(const QString& key);

 private:
  Settings() = default;
};

}  // namespace felt::desktop
