#pragma once

/// The keys of a guide in an event line. Private to this layer. Errors start with the key.

#include "felt/io/events/event_fields.h"

namespace felt::json {

inline constexpr NumberLimit kEventTimeLimit = {limits::kMaxEventTimeMs, "1e9"};

/// Parses `points`: [[x,y],...] in mm.
Result<void> parse_guide_points(Value& value, EventFields& out);
/// Parses `times_ms`: one time for each point.
Result<void> parse_guide_times(Value& value, EventFields& out);
/// Parses `kind` of an event "guides".
Result<void> parse_guide_kind(Value& value, EventFields& out);
/// Parses `axes`.
Result<void> parse_guide_axes(Value& value, EventFields& out);
/// Parses `stroke`.
Result<void> parse_guide_stroke(Value& value, EventFields& out);
/// Returns the guides event of these fields: only the fields that its action uses. Fails if one of
/// them is missing or invalid.
Result<GuidesEvent> guides_event(EventFields&& fields);
/// Parses `closed`.
Result<void> parse_closed_guide(Value& value, EventFields& out);
/// Of an edges event.
Result<void> parse_edges_page(Value& value, EventFields& out);
Result<void> parse_edges_selection(Value& value, EventFields& out);
Result<void> parse_edges_contours(Value& value, EventFields& out);

}  // namespace felt::json
