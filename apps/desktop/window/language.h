#pragma once

#include <QString>
#include <QStringList>

namespace felt::desktop {

/// "en", "de", "nl": what the program speaks.
QStringList languages();

/// Has the program speak from now on; before the first widget is made. "" means what a person chose
/// in the preferences, or the system's. An unknown one is English. Numbers in files are not touched
/// by it. Returns what it is.
QString use_language(const QString& language);

}  // namespace felt::desktop
