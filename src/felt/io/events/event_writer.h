#pragma once

#include <string>

#include "felt/session/event.h"

namespace felt {

/// Appends one event as a line of a script, terminator included (docs/formats/events.md). Keys come
/// in a fixed order, numbers in the shortest form that reads back as the same double whatever the
/// locale; a pen's pressure is left out where there is none, and its buttons where none is down.
/// So equal events give equal bytes, and what EventReader accepts reads back as it was.
///
/// Requires what the reader will: finite numbers, texts in UTF-8, a time from 0 to 1e9 ms.
void append_event_line(std::string& out, const Event& event);

}  // namespace felt
