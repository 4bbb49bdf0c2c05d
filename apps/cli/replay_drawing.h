#pragma once

#include <string>
#include <utility>
#include <vector>

#include "felt/formats/drawing_reader.h"
#include "felt/session/session.h"

namespace felt::cli {

/// Options before the first event, by id and value as text: what a session that goes on with this
/// drawing draws on and with, its sheet and its colour as far as it says them. A sheet that is not
/// among `known` is left out.
std::vector<std::pair<std::string, std::string>> options_of(const StoredDrawing& drawing,
                                                            const Materials& known);

/// The drawing that a session leaves: `start`, which it began with, with this document, and with
/// the sheet, the colour, the layer and the texts of the materials that it uses now.
OpenedDrawing drawing_after(OpenedDrawing start, const Session& session, Document document);

/// The document as it is seen: what a gesture in work would do is done.
Document seen_document(const Session& session);

}  // namespace felt::cli
