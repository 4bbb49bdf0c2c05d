#pragma once

#include <string>
#include <string_view>

#include "felt/base/result.h"

namespace felt {

/// Whether a document type with definitions of its own stands before the first element.
bool has_svg_entities(std::string_view text) noexcept;

/// The text with its document type blanked out, line ends kept, and the entities that it defines as
/// text put in, as some drawing programs write them for their namespaces. Those that refer to a
/// file stay as they are and mean nothing; so do entities inside of entities, which could grow
/// without end.
/// Error: they add more than limits::kMaxSvgEntityBytes, or the document type does not end.
Result<std::string> svg_with_entities(std::string_view text);

}  // namespace felt
