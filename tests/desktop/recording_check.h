#pragma once

#include <QString>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "felt/geometry/point.h"
#include "felt/session/event.h"

namespace felt::desktop {

/// Returns the poses of a recording, in order. Ignores an incomplete last line, because the program
/// may still be writing. Fails if the recording cannot be read.
Result<std::vector<PenEvent>> poses_of(const QString& recording);

/// Returns how many of `places` occur among the poses, in this order and to 1e-6 mm. Stops at the
/// first position that does not occur.
std::size_t count_places(std::span<const PenEvent> poses, std::span<const Point> places);

/// Runs `feltline replay RECORDING --as-recorded` and returns its sketch as .ndjson text. Fails if
/// the program fails; the error is its message.
Result<std::string> replayed(const QString& feltline, const QString& recording);

}  // namespace felt::desktop
