#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "felt/document/document.h"
#include "felt/io/import.h"
#include "felt/material/materials.h"

namespace felt {

/// The texts that a drawing must bring along: of its sheet and of the media of its strokes, as far
/// as Feltline does not have them, or has them otherwise. `also`: media that it may use next. One
/// that no text can hold, or more than limits::kMaxMaterialTexts, is left out.
std::vector<std::string> texts_of_used(const Document& document, std::string_view surface,
                                       const Materials& known,
                                       std::span<const std::string> also = {});

/// The known materials, those that a drawing brings along in their place where ids are the same:
/// in it they are what it says. A text that says none is passed over.
Materials with_texts(std::span<const std::string> texts, Materials known = Materials::built_in());

/// Removes texts that say no material; `report` names each with the reason. For drawings that were
/// read: nobody vouches for them.
void drop_bad_texts(std::vector<std::string>& texts, ImportReport& report);

}  // namespace felt
