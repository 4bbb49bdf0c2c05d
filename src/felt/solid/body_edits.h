#pragma once

#include <atomic>
#include <span>
#include <string>
#include <vector>

#include "felt/base/result.h"
#include "felt/document/body_edit.h"
#include "felt/document/document.h"
#include "felt/solid/extrude_body.h"
#include "felt/solid/solid.h"

namespace felt {

/// A solid after its edits.
struct EditedSolid {
  Solid solid;
  /// One sentence for each edit, in their order: why it was left out and where, or empty if it was
  /// applied.
  std::vector<std::string> refusals;
  /// The same without the name and the place of the edit, for one that was just drawn.
  std::vector<std::string> reasons;
};

/// Applies the edits of a drawing to the bodies that it inflates to, one after the other:
/// cut_body(), extrude_body(), smooth_body() and, after all others, paint_body(). A painted line
/// is projected on the bodies as they are when its turn comes, and keeps its position in space when
/// later edits change the surface near it.
///
/// A cut and a painted line act on each body that the stroke meets; an extrusion and a smoothing
/// act on the body that the eye sees at the first point of the stroke, or, if it sees none there,
/// on the first body that the stroke meets. An edit that does not fit is left out: the others still
/// apply. So if the drawing changes, the same edits are applied to its new bodies.
///
/// Every body passes check_body(). The same solid and edits give the same bytes. If `is_cancelled`
/// becomes true, the next edit is not begun, and the result is not complete.
EditedSolid apply_body_edits(Solid solid, std::span<const BodyEdit> edits,
                             const std::atomic<bool>* is_cancelled = nullptr);

/// Returns the edits of the body of a document, in the order in which they are applied.
std::vector<BodyEdit> body_edits_of(const Document& document);

/// Projects the closed stroke of an extrusion on the body below it. Fails like extrude_body().
Result<ExtrusionRing> extrusion_ring(const Solid& solid, const BodyEdit& edit);

}  // namespace felt
