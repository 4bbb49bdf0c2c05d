#pragma once

#include <string>

#include "felt/session/event.h"

namespace felt {

/// Appends one event as a line of a script, with its terminator (docs/formats/events.md). Keys have
/// a fixed order. Numbers have the shortest form that reads back as the same double in any locale.
/// The pressure is omitted if the sample has no pressure, and the buttons if no button is pressed.
/// Equal events therefore give equal bytes, and an event that EventReader accepts reads back
/// unchanged.
///
/// Requires values that the reader accepts: finite numbers, texts in UTF-8, a time from 0 to 1e9
/// ms.
void append_event_line(std::string& out, const Event& event);

}  // namespace felt
