#pragma once

#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "felt/fill/fill_shape.h"
#include "felt/fill/follow_fill.h"

namespace felt {

/// A part of a stroke that bounded a fill, on the stroke as it is after an edit. On a closed stroke
/// the parameters may lie outside of 0..n, so that a run can pass the seam.
struct BoundaryRun {
  StrokeId stroke;
  double from = 0.0;
  double to = 0.0;
};

/// Returns the runs of a loop, with their parameters carried over to the strokes after the edit, in
/// the order of the loop. Bridges, and parts that have disappeared, are left out.
std::vector<BoundaryRun> runs_after(const FillLoop& loop, const LineMeetings& now,
                                    std::span<const LineEdit> edits);

/// How neighbouring runs may be joined.
struct JoinRules {
  std::span<const TipLink> links;
  bool close_gaps = false;  ///< a bridge joins neighbours that do not meet
  /// How far the ends of both runs together may move to a meeting or link.
  double max_move_mm = std::numeric_limits<double>::infinity();
};

/// Moves the ends of the runs to the meetings and links that are nearest to them, and returns the
/// loop. Nullopt if neighbours do not meet and the gap may not be closed, if a run would turn
/// around, or if nothing is enclosed.
std::optional<FillLoop> join_runs(const std::vector<BoundaryRun>& runs, const LineMeetings& now,
                                  const JoinRules& rules);

}  // namespace felt
