#pragma once

/// The keys of the events "timing" and "view". Private to this layer. Errors start with the key.

#include "felt/io/events/event_fields.h"

namespace felt::json {

/// Parse `between` and `hold`, whole numbers.
Result<void> parse_timing_between(Value& value, EventFields& out);
Result<void> parse_timing_hold(Value& value, EventFields& out);
/// Parses `ease`: four numbers from 0 to 1.
Result<void> parse_timing_ease(Value& value, EventFields& out);
/// Parses `pairs`: [[from,to],...], where 0 stands for no stroke.
Result<void> parse_timing_pairs(Value& value, EventFields& out);
/// Parses `hidden` of an event "view": numbers of layers.
Result<void> parse_hidden_layers(Value& value, EventFields& out);
/// Returns the timing event of these fields. Fails if one of them is missing or invalid.
Result<TimingEvent> timing_event(EventFields&& fields);

}  // namespace felt::json
