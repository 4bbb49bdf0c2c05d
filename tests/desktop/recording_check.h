#pragma once

#include <QString>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "felt/geometry/point.h"
#include "felt/session/event.h"

namespace felt::desktop {

/// The poses of a recording, in order, of its whole lines: it may still be written. Error: it
/// cannot be read.
Result<std::vector<PenEvent>> poses_of(const QString& recording);

/// How many of these places are poses, exactly (to 1e-6 mm) and in this order; the search ends at
/// the first that is not.
std::size_t count_places(std::span<const PenEvent> poses, std::span<const Point> places);

/// The sketch, as .ndjson text, that `feltline replay RECORDING --as-recorded` makes. Error: what
/// the program said.
Result<std::string> replayed(const QString& feltline, const QString& recording);

}  // namespace felt::desktop
