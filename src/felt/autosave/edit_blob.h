#pragma once

#include <string>
#include <string_view>

#include "felt/base/result.h"
#include "felt/document/document.h"
#include "felt/document/edit.h"

namespace felt {

/// Appends what an edit leaves behind as bytes, for the autosave: which strokes and layers it
/// makes, changes and removes, and where they stand. What they were before is not written; the
/// document that the edit is applied to knows that.
Result<void> append_edit_blob(std::string& out, const Edit& edit);

/// Returns the complete edit that these bytes describe, to be applied to this document. Fails if
/// the bytes are damaged, or name something that the document does not have.
Result<Edit> read_edit_blob(std::string_view bytes, const Document& document);

/// Applies as much of the edit as fits this document, which is not the one that it was written for:
/// a stroke that is missing is added on top of its layer, or of the highest one; one that is there
/// is replaced. For the rest of a damaged database. Fails without a change if the bytes are
/// damaged.
Result<void> apply_what_fits(std::string_view bytes, Document& document);

}  // namespace felt
