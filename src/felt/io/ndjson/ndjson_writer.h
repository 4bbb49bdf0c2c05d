#pragma once

#include <span>
#include <string>
#include <string_view>

#include "felt/base/result.h"
#include "felt/document/document.h"
#include "felt/io/ndjson/json_text.h"
#include "felt/io/ndjson/ndjson_record.h"

namespace felt {

/// Each function appends one line to `out`, with its terminator. Keys have a fixed order, and
/// numbers have the shortest form that reads back as the same double in any locale, so equal values
/// give equal bytes. Ids and materials must be UTF-8.

/// Appends {"id":..,"closed":..,"segments":..,"joints":..,"widths":..}, with "material" and "color"
/// if they differ from the defaults.
void append_sketch_line(std::string& out, std::string_view id, const StrokeData& data);

/// For each stroke of the visible layers, appends a line as append_sketch_line() does, with
/// stroke_name() as the id.
void append_sketch_lines(std::string& out, const Document& document);

/// Fails if the magnitude of a coordinate or width exceeds limits::kMaxSketchNumber, because such a
/// line could not be read back.
Result<void> check_sketch_numbers(const StrokeData& data);

/// Appends {"id":..,"points":[[x,y,pressure|null,t_ms|null],...]}. Pressure or time is omitted if
/// no sample has one.
void append_raw_line(std::string& out, std::string_view id, std::span<const InkSample> samples);

}  // namespace felt
