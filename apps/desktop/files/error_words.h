#pragma once

#include <QString>

#include "felt/base/result.h"

namespace felt::desktop {

/// Returns a translated sentence for the code of an error. The library's own message, which is in
/// English and names path and position, is shown under "Details".
QString error_words(const Error& error);

}  // namespace felt::desktop
