#pragma once

#include <string>
#include <string_view>

#include "felt/base/result.h"
#include "felt/document/drawing.h"

namespace felt {

/// Appends `text` as the value of an attribute in double quotes. Fails, and appends nothing, if the
/// text is not UTF-8 or has a character that XML forbids (most control characters, U+FFFE, U+FFFF).
Result<void> append_xml_attribute(std::string& out, std::string_view text);

/// Returns name_in_file(), or stroke_name() if XML forbids that name.
std::string xml_stroke_name(const Drawing& drawing, StrokeId id);

/// Returns true if DrawingBuilder would give other ids to the strokes of a file that has only their
/// names.
bool need_numbers(const Drawing& drawing);

}  // namespace felt
