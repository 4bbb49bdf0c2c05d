#pragma once

#include <QString>

/// The stored settings of the keyboard (engine/settings.h), besides the keys of each command.
namespace felt::desktop::key_keys {

/// False if letters, digits and signs alone are no shortcuts, for users of speech input and users
/// who hit keys by accident (WCAG 2.1, 2.1.4).
inline const QString kSingleCharacters = QStringLiteral("keys/single_characters");

}  // namespace felt::desktop::key_keys
