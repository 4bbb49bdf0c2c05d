// The edits of the body of a document, which are in no layer.
#include "felt/document/document.h"

namespace felt {

BodyEditPtr Document::find_body_edit(BodyEditId id) const {
  const auto found = body_edits_.find(id);
  return found == body_edits_.end() ? nullptr : found->second;
}

}  // namespace felt
