#pragma once

#include <string>

#include "felt/render/line_style.h"
#include "felt/stroke/stroke.h"

namespace felt {

/// Returns true if Inkscape has a path effect that draws lines with this style: Pattern Along Path,
/// for a shape that is repeated or stretched. `style` may be null.
bool has_pattern_effect(const StrokeStyle* style) noexcept;

/// Appends the effect with this id as a definition. Inkscape applies it when the line is edited.
/// The pattern has one width on the whole line, the stroke's mean width, and as many copies as on
/// the stroke if it has no corners. Requires has_pattern_effect().
void append_pattern_effect(std::string& out, const Stroke& stroke, const StrokeStyle& style,
                           const std::string& id);

}  // namespace felt
