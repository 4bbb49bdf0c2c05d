#pragma once

#include <QString>

#include "felt/base/result.h"

namespace felt::desktop {

/// What an error means for a person, translated: one sentence by its code. The library's own words
/// are English and name paths and places; they go under "Details".
QString error_words(const Error& error);

}  // namespace felt::desktop
