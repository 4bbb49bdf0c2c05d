#pragma once

/// The keys of an event of layers or pictures. Private to this layer. Errors start with the key.

#include "felt/io/events/event_fields.h"

namespace felt::json {

/// Parses `id`, the number of a layer or of another object.
Result<void> parse_layer(Value& value, EventFields& out);
/// Read the "id" of an event for a guide or for an edit of the body, also into `layer`.
Result<void> parse_guide_id(Value& value, EventFields& out);
Result<void> parse_body_id(Value& value, EventFields& out);
Result<void> parse_timing_of(Value& value, EventFields& out);
/// Adds the number of a layer to a list.
Result<void> parse_layer_number(Value& value, std::vector<LayerId>& out);
/// Parses `ids`: numbers of layers.
Result<void> parse_layers(Value& value, EventFields& out);
/// Parses `group`.
Result<void> parse_group(Value& value, EventFields& out);
/// Parses `index`.
Result<void> parse_index(Value& value, EventFields& out);
/// Parses `matrix`: the place of a picture.
Result<void> parse_matrix(Value& value, EventFields& out);
/// Parses `mode`: a blend mode.
Result<void> parse_mode(Value& value, EventFields& out);
/// Parses `png`: a PNG file in base64.
Result<void> parse_png(Value& value, EventFields& out);

}  // namespace felt::json
