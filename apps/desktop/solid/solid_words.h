#pragma once

#include <QString>
#include <QStringList>
#include <string_view>

namespace felt::desktop {

/// Translates a sentence of the layer `solid` about a body that is not possible, or about what was
/// left out, with its places and names. The library has these sentences only in English, and a
/// sentence may contain another one. Begins with a capital letter and ends with a full stop. A
/// sentence that is not in the table stays English.
QString solid_words(std::string_view sentence);

/// Returns the sentences of the table, in English, with %1, %2 ... for what varies.
QStringList solid_sentences();

}  // namespace felt::desktop
