#pragma once

#include <QString>
#include <QStringList>

namespace felt::desktop {

/// Returns the languages of the program: "en", "de", "nl".
QStringList languages();

/// Sets the language of the program and returns it. Call it before the first widget is made. If
/// `language` is "", uses the user's choice in the preferences or, without one, the system's
/// language. If the language is unknown, uses English. The format of numbers in files does not
/// depend on the language.
QString use_language(const QString& language);

}  // namespace felt::desktop
