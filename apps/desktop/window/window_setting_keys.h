#pragma once

#include <QString>

/// What the window keeps from one start to the next.
namespace felt::desktop::window_keys {

/// "system", "light" or "dark".
inline const QString kTheme = QStringLiteral("window/theme");
/// "" as the system says, else "en", "de", "nl"; counts from the next start on.
inline const QString kLanguage = QStringLiteral("window/language");
inline const QString kGeometry = QStringLiteral("window/geometry");
inline const QString kLayout = QStringLiteral("window/layout");
/// The drawing that was open last comes back at the next start.
inline const QString kReopenLast = QStringLiteral("window/reopen_last");

/// Its path.
inline const QString kLastFile = QStringLiteral("window/last_file");

}  // namespace felt::desktop::window_keys
