#pragma once

#include <string>
#include <string_view>

#include "felt/base/result.h"
#include "felt/document/document.h"
#include "felt/document/edit.h"

namespace felt {

/// Appends the result of an edit as bytes, for the autosave: the strokes, fills, layers,
/// guides, symmetry groups and edits of the body that the edit adds, changes and removes, and their
/// positions. The state of these objects before the edit is not written, because the document to
/// which the edit is applied has that state.
Result<void> append_edit_blob(std::string& out, const Edit& edit);

/// Returns the complete edit that these bytes describe, for this document. Fails if the bytes are
/// damaged, or if they name an object that the document does not have.
Result<Edit> read_edit_blob(std::string_view bytes, const Document& document);

/// Applies those parts of the edit that fit this document. The document may differ from the
/// document for which the edit was written. A missing stroke is added on top of its layer, or on
/// top of the highest layer if its layer is missing. An existing stroke is replaced. The same
/// applies to fills and guides. Used for damaged databases. Fails without a change if the bytes are
/// damaged.
Result<void> apply_what_fits(std::string_view bytes, Document& document);

}  // namespace felt
