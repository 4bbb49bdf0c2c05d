#pragma once

#include <optional>

#include "felt/document/edit.h"

namespace felt {

/// Returns the edit that turns the result of the edit `drawn` into the result of the edit `other`.
/// Both add the same line to the same document, with different curves. Returns nullopt if they
/// differ in anything else, for example because only one line reaches a target, or if the lines
/// are equal.
std::optional<Edit> replaced_line(const Edit& drawn, const Edit& other);

}  // namespace felt
