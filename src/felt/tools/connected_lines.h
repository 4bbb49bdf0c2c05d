#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "felt/document/document.h"
#include "felt/document/selection.h"
#include "felt/document/stroke_index.h"

namespace felt {

/// The part of one stroke that a transform moves.
struct MovedLine {
  /// A point on a line that comes earlier in the list.
  struct Leader {
    std::size_t line = 0;
    double u = 0.0;
  };

  StrokeId id;
  StrokePtr stroke;        ///< as in the document, possibly with added joints
  Selection::Marks marks;  ///< closed (point_marks.h)
  /// If set, the marked end is shifted by the displacement of this point instead of being mapped.
  std::optional<Leader> leader;
  /// The user selected the whole line; otherwise connected lines may demand all of its points, too.
  bool is_selected_whole = false;
};

/// The lines that move with a selection.
struct ConnectedLines {
  std::vector<MovedLine> lines;
  /// Whether lines that share a point may part if each of them moves according to its marks.
  bool may_part = false;
};

/// Returns the lines that move if `selected` moves (R33, R34): first `selected`, then the editable
/// strokes that share a point with moving ink, as follows (a point is mapped if the transform
/// itself moves it):
///   - an end on a point that is mapped is marked; an end on a part that bends gets a leader;
///   - a stroke on which a mapped end lies gets a joint there, which is marked;
///   - strokes that share a point with these follow in the same manner, recursively.
/// The same applies to a stroke of the selection that moves only in part: where it shares a point
/// that is mapped, it is marked there. If an end of such a stroke is not marked but lies on a part
/// that bends, that part gets a joint there, which stays. So lines that are selected in part share
/// their points exactly after the transform, and the inverse map restores them.
///
/// Exception: if a stroke moves only in part, an end that shares a point with a stroke of a locked
/// layer is unmarked, so that this end stays and holds the stroke back. A stroke that moves as a
/// whole separates from the locked stroke.
///
/// Sets `may_part` if an end follows a part that bends, or a locked stroke holds a moving point:
/// then ConnectedPull must close the remaining gaps.
ConnectedLines connected_lines(const Document& document, const StrokeIndex& index,
                               std::vector<MovedLine> selected);

}  // namespace felt
