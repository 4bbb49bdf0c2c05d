#pragma once

#include <QString>

/// The settings of the window, kept between starts.
namespace felt::desktop::window_keys {

/// "system", "light" or "dark".
inline const QString kTheme = QStringLiteral("window/theme");
/// "" for the system's language, otherwise "en", "de", "nl"; takes effect at the next start.
inline const QString kLanguage = QStringLiteral("window/language");
inline const QString kGeometry = QStringLiteral("window/geometry");
inline const QString kLayout = QStringLiteral("window/layout");
/// The last drawing is opened again at the next start.
inline const QString kReopenLast = QStringLiteral("window/reopen_last");

/// The path of that drawing.
inline const QString kLastFile = QStringLiteral("window/last_file");

}  // namespace felt::desktop::window_keys
