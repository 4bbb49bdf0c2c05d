#pragma once

#include <QString>

#include "felt/base/result.h"

namespace felt::desktop {

/// Returns one translated sentence for an error, by its code. The library's own messages are in
/// English and name paths and positions; they are shown under "Details".
QString error_words(const Error& error);

}  // namespace felt::desktop
