#pragma once

#include <span>

#include "felt/base/result.h"
#include "felt/fill/line_meetings.h"

namespace felt {

/// Fails if lines lie so close beside each other, as in the noise of a scan, that finding their
/// outlines would take minutes: if each of more than 500 cells of a grid has more than 20 times
/// its width of line. A cell is a 256th of the drawing wide. The message says where most of the
/// line is, and how much (kLimitExceeded). The time is linear in the number of segments.
Result<void> check_line_density(std::span<const FillLine> lines);

}  // namespace felt
