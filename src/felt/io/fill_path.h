#pragma once

#include "felt/document/fill.h"
#include "felt/stroke/outline/outline_path.h"

namespace felt {

/// Returns the loops of a fill as closed curves, for vector files. Fill them by the even-odd rule.
OutlinePath fill_path(const Fill& fill);

}  // namespace felt
