#pragma once

#include <string>

#include "felt/base/result.h"
#include "felt/session/document_events.h"
#include "felt/stroke/stroke.h"

namespace felt {

/// Returns the stroke that the event adds. Fails if it has too few or too many points, if a number
/// is not finite or out of range, or if the line is too short (or, if closed, no line at all)
/// without the points that are too close to the one before. The message starts with the key of the
/// event.
Result<Stroke> stroke_of_line(const AddLine& line, const std::string& medium, Rgba color);

}  // namespace felt
