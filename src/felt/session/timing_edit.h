#pragma once

#include "felt/base/result.h"
#include "felt/document/document.h"
#include "felt/session/event.h"

namespace felt {

/// Returns the whole effect of an event on the timings of layers as one edit, which is one undo
/// step. The edit is empty if nothing changes. Fails if the event has no layer, if a layer does not
/// exist, or if check_key_timing() refuses a new timing.
Result<Edit> timing_edit(const Document& document, const TimingEvent& event);

/// Returns the whole effect of an event on the edits of the body of a document as one edit, which
/// is one undo step. Fails if the edit of the body to remove does not exist, if check_body_edit()
/// refuses the new one, or if the drawing has too many (kMaxBodyEdits).
Result<Edit> body_edit_edit(const Document& document, const BodyEvent& event);

}  // namespace felt
