#pragma once

#include <QString>
#include <QStringList>

namespace felt::desktop {

/// Returns the languages of the program: "en", "de", "nl".
QStringList languages();

/// Sets the language of the program and returns it. Call it before the first widget is made. If
/// `language` is "", uses the language that the user has chosen in the preferences, or the system's
/// language if the user has chosen none. If the language is unknown, uses English. The format of
/// numbers in files does not depend on the language.
QString use_language(const QString& language);

}  // namespace felt::desktop
