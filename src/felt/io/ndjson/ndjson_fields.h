#pragma once

/// The keys of raw and sketch records, each parsed into its field. Private to this layer. Error
/// messages start with the key and, in lists, the index.

#include "felt/io/ndjson/ndjson_json.h"
#include "felt/io/ndjson/ndjson_record.h"

namespace felt::json {

/// Reads an id: a string, or a number, which is stored as it is written in the file.
Result<void> parse_id(Value& value, std::string& out);
/// Reads [[x,y,pressure|null,t_ms|null],...]; pressure and time may be missing. A fifth element may
/// be an object with the tilt; other elements are ignored.
Result<void> parse_points(Value& value, std::vector<InkSample>& out);

Result<void> parse_closed(Value& value, bool& out);
/// Reads [[x1,y1,..,x4,y4],...]; each segment must start exactly where the previous one ends.
Result<void> parse_segments(Value& value, std::vector<Point>& out);
/// Reads ["smooth"|"corner",...].
Result<void> parse_joints(Value& value, std::vector<JointKind>& out);
/// Reads [[u,width],...].
Result<void> parse_widths(Value& value, std::vector<WidthKnot>& out);
/// Reads [tone,...], each within 0..1.
Result<void> parse_tones(Value& value, std::vector<double>& out);
Result<void> parse_material(Value& value, std::string& out);
/// Reads "#rrggbb" or "#rrggbbaa".
Result<void> parse_color(Value& value, Rgba& out);

/// Checks that the format version in a header is 1.
Result<void> parse_version(Value& value);
/// Checks that the unit in a header is "mm".
Result<void> parse_unit(Value& value);

}  // namespace felt::json
