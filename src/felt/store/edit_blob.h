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

}  // namespace felt
