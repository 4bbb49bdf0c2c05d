#pragma once

#include <string>
#include <utility>
#include <vector>

#include "felt/formats/drawing_reader.h"
#include "felt/session/session.h"

namespace felt {

/// Returns the options, id and value as text, with which a session continues this drawing: its
/// surface and its colour, if it has them. A surface that is not among `known` is left out.
std::vector<std::pair<std::string, std::string>> options_of(const Drawing& drawing,
                                                            const Materials& known);

/// Returns the drawing that results from a session that began with `start`: with this document,
/// and with the surface, colour, layer and material texts that the session uses now.
Drawing drawing_after(Drawing start, const Session& session, Document document);

/// Returns the document as it is shown, with the preview of the gesture in progress applied.
Document seen_document(const Session& session);

}  // namespace felt
