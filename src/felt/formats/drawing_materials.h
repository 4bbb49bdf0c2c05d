#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "felt/document/document.h"
#include "felt/io/import.h"
#include "felt/material/materials.h"

namespace felt {

/// Returns the material texts that a drawing must contain: those of its surface and of the media of
/// its strokes, if they are not built in or differ from the built-in ones. `also` has the ids of
/// further media that the drawing may use next. Leaves out materials that no text can describe, and
/// all materials after the first limits::kMaxMaterialTexts.
std::vector<std::string> texts_of_used(const Document& document, std::string_view surface,
                                       const Materials& known,
                                       std::span<const std::string> also = {});

/// Returns the known materials together with those of a drawing's texts. If two have the same id,
/// the drawing's material replaces the known one. Ignores a text that is not a valid material.
Materials with_texts(std::span<const std::string> texts, Materials known = Materials::built_in());

/// Removes texts that are not valid materials, and reports each of them in `report` with the
/// reason. Called after a drawing was read, because files are not trusted.
void drop_bad_texts(std::vector<std::string>& texts, ImportReport& report);

}  // namespace felt
