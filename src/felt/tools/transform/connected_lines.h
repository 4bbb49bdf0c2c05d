#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "felt/document/document.h"
#include "felt/document/selection.h"
#include "felt/document/stroke_index.h"

namespace felt {

/// What a transform moves of one stroke.
struct MovedLine {
  /// A place on a line before this one in the list.
  struct Leader {
    std::size_t line = 0;
    double u = 0.0;
  };

  StrokeId id;
  StrokePtr stroke;        ///< as in the document, or with more joints
  Selection::Marks marks;  ///< closed (point_marks.h)
  /// If set, the marked end is shifted as this place is, instead of being mapped.
  std::optional<Leader> leader;
};

/// The lines that move when `selected` do (R33, R34): those first, then the strokes that share a
/// point with something that moves, as far as they may be edited:
///   - an end that lies on a mapped place is marked, and one on a part that bends gets a leader;
///   - a stroke on which a mapped end stands gets a joint there, which is marked;
///   - and so on from there.
/// Strokes of the selection keep their marks. There is one exception: if a stroke moves only in
/// part, its end that shares a point with a stroke of a locked layer is unmarked, so that it stays
/// and holds. A stroke that moves as a whole leaves the locked one.
std::vector<MovedLine> connected_lines(const Document& document, const StrokeIndex& index,
                                       std::vector<MovedLine> selected);

}  // namespace felt
