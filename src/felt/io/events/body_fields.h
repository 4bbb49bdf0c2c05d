#pragma once

/// The keys of an event of the body. Private to this layer. Errors start with the key.

#include "felt/io/events/event_fields.h"

namespace felt::json {

/// Parses `kind`.
Result<void> parse_body_kind(Value& value, EventFields& out);
/// Parse `path` and `profile`: [[x,y,z],...] in mm.
Result<void> parse_body_path(Value& value, EventFields& out);
Result<void> parse_body_profile(Value& value, EventFields& out);
/// Parses `view`: [x,y,z].
Result<void> parse_body_view(Value& value, EventFields& out);
/// Parses `color`.
Result<void> parse_body_color(Value& value, EventFields& out);
/// Returns the body event of these fields: only the fields that its action uses. Fails if one of
/// them is missing or invalid.
Result<BodyEvent> body_event(EventFields&& fields);

}  // namespace felt::json
