#pragma once

#include <QString>

/// The stored settings of the window (engine/settings.h).
namespace felt::desktop::window_keys {

/// Theme: "system", "light" or "dark".
inline const QString kTheme = QStringLiteral("window/theme");
/// Language: "en", "de" or "nl", or "" for the system's language. A change takes effect at the next
/// start.
inline const QString kLanguage = QStringLiteral("window/language");
inline const QString kGeometry = QStringLiteral("window/geometry");
inline const QString kLayout = QStringLiteral("window/layout");
/// True if Feltline opens the last drawing (kLastFile) when it starts.
inline const QString kReopenLast = QStringLiteral("window/reopen_last");

/// True after the user has pulled a line: then PullHint is not needed any more.
inline const QString kHasPulled = QStringLiteral("window/has_pulled");

/// The path of the drawing that was opened or saved last.
inline const QString kLastFile = QStringLiteral("window/last_file");

}  // namespace felt::desktop::window_keys
