#pragma once

#include <QString>

#include "felt/tactile/swell_paper.h"

namespace felt::desktop {

/// Says what was changed for swell paper, in sentences, with counts. Empty if nothing was changed.
QString swell_words(const SwellReport& report);

}  // namespace felt::desktop
