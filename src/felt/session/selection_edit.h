#pragma once

#include <optional>
#include <string>

#include "felt/base/result.h"
#include "felt/document/document.h"
#include "felt/document/selection.h"
#include "felt/session/event.h"
#include "felt/tools/moved_strokes.h"
#include "felt/tools/scene.h"

namespace felt {

/// Offset of a duplicate from its original, to the right and down.
inline constexpr double kDuplicateShiftMm = 5.0;

/// Returns the selection after a select event. It contains strokes of visible, unlocked layers
/// only.
Selection selected(const Document& document, const Selection& before, SelectStrokes::What what);

/// Removes the strokes that are wholly selected. Strokes that are selected in part are not changed,
/// because the user could not foresee the shape of a stroke without some of its control points. The
/// edit is empty if no stroke is wholly selected.
Edit delete_edit(const Document& document, const Selection& selection);

/// Copies the strokes that are wholly selected, in drawing order, to the top of their layers. The
/// copies are shifted by kDuplicateShiftMm. The edit is empty if no stroke is wholly selected.
/// Fails if a shifted stroke breaks an invariant: at very large coordinates, rounding can make its
/// points invalid. The message names the stroke. Also fails if check_copies() refuses the copies.
Result<Edit> duplicate_edit(const Document& document, const Selection& selection);

/// An edit, and the selection after it if the edit adds joints to selected strokes.
struct MoveEdit {
  Edit edit;
  std::optional<Selection> selection{};
};

/// Fails if the offset of the event is invalid.
Result<void> check_move(const MoveEvent& event);
/// Moves the strokes of scene.selection that are wholly selected, as a drag of the transform tool
/// does: lines that share a point with them follow (MovedStrokes). The edit is empty if no stroke
/// is wholly selected or the offset is 0. Fails if a stroke breaks an invariant at its new
/// position. Requires an event that check_move() accepts.
Result<MoveEdit> move_edit(const Scene& scene, Vec by_mm);
/// Moves the strokes that are wholly selected, and no others. Fails as move_edit().
Result<Edit> move_alone_edit(const Document& document, const Selection& selection, Vec by_mm);

/// Moves the strokes that are wholly selected to the top or the bottom of their layers. The edit is
/// empty if they are there already.
Edit order_edit(const Document& document, const Selection& selection, OrderEvent::To to);

/// Limit to which restyle_edit() broadens a stroke. Strokes that are already broader keep their
/// width.
inline constexpr double kMaxRestyledWidthMm = 50.0;

/// Changes the strokes that are selected wholly or in part as the event says. The edit is empty if
/// nothing changes. Fails if the event's colour, opacity or width factor is invalid; does not check
/// its medium.
Result<Edit> restyle_edit(const Document& document, const Selection& selection,
                          const RestyleEvent& event);

/// Returns a selection in which all strokes that the edit adds are wholly selected.
Selection made_by(const Edit& edit);

}  // namespace felt
