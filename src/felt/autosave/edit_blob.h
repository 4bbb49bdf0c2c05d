#pragma once

#include <string>
#include <string_view>

#include "felt/base/result.h"
#include "felt/document/document.h"
#include "felt/document/edit.h"

namespace felt {

/// Appends what an edit leaves behind as bytes, for a journal: which strokes and layers it makes,
/// changes and removes, and where they stand. What they were before is not written; the document
/// that the edit is applied to knows that.
Result<void> append_edit_blob(std::string& out, const Edit& edit);

/// The edit that these bytes say of this document, complete, to be applied to it. Error: bytes
/// that are damaged, or that name what the document has not got.
Result<Edit> read_edit_blob(std::string_view bytes, const Document& document);

/// Carries out as much of it as this document can take, which is not the one that it was written
/// for: a stroke that is not there is made on top of its layer, or of the highest; one that is
/// there is replaced in its place. For what is left of a damaged store. Error: bytes that are
/// damaged; nothing was done.
Result<void> apply_what_fits(std::string_view bytes, Document& document);

}  // namespace felt
