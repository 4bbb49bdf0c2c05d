#pragma once

#include <string>
#include <utility>
#include <vector>

#include "felt/formats/drawing_reader.h"
#include "felt/session/session.h"

namespace felt {

/// Returns the options with which a session continues this drawing, as ids and values in text form:
/// the surface and the colour, if the drawing has them. A surface that is not in `known` is
/// omitted.
std::vector<std::pair<std::string, std::string>> options_of(const Drawing& drawing,
                                                            const Materials& known);

/// Returns a copy of `start`, the drawing with which the session began, but with this document and
/// with the session's current surface, colour, layer and material texts.
Drawing drawing_after(Drawing start, const Session& session, Document document);

/// Returns the document as it is shown, with the preview of the gesture in progress applied.
Document seen_document(const Session& session);

}  // namespace felt
