#pragma once

#include <string>
#include <string_view>

#include "felt/base/result.h"
#include "felt/document/drawing.h"

namespace felt {

/// Appends `text` as the value of an attribute in double quotes. Fails, and appends nothing, if the
/// text is not UTF-8 or has a character that XML forbids (most control characters, U+FFFE, U+FFFF).
Result<void> append_xml_attribute(std::string& out, std::string_view text);

/// Returns the name of its own that a stroke has (Drawing::names), or an empty string if it has
/// only stroke_name(), or if XML forbids its name.
std::string xml_own_name(const Drawing& drawing, StrokeId id);

}  // namespace felt
