#pragma once

#include <QString>
#include <QStringList>

namespace felt::desktop {

/// Returns the languages of the program: "en", "de", "nl".
QStringList languages();

/// Sets the language of the program. Call it before the first widget is made. "" means the user's
/// choice in the preferences, or else the system's language. An unknown language gives English.
/// Numbers in files do not depend on it. Returns the language that is used.
QString use_language(const QString& language);

}  // namespace felt::desktop
