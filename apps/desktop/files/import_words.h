#pragma once

#include <QString>
#include <QStringList>
#include <string_view>

namespace felt::desktop {

/// Translates ImportNotice::what, which the library has only in English: what a reader did with
/// unsupported content. A sentence that is not in the table stays English.
QString import_words(std::string_view what);

/// Returns the sentences of the table, in English, with %1, %2 ... for what varies.
QStringList import_sentences();

}  // namespace felt::desktop
