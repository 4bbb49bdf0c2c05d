#pragma once

#include <string>

#include "felt/base/result.h"
#include "felt/document/document.h"
#include "tests/drawing/snapping/snap_scenes.h"

namespace felt::snap_test {

/// Who draws.
struct SnapHand {
  std::string name = "typical";  ///< of simulated_hands()
  std::string device = "touch";
  bool forces = true;
  std::uint64_t tremor_seed = 0;  ///< 0: only that of WritingHand
};

/// What came of a scene.
struct SnapCount {
  int meant = 0;    ///< strokes drawn
  int strokes = 0;  ///< in the document
  int closed = 0;
  double mean_mm = 0.0;     ///< from the path that the hand meant to the ink
  std::vector<Stroke> ink;  ///< the strokes in drawing order

  /// Strokes that became part of others.
  [[nodiscard]] int joined() const { return meant - strokes; }
};

/// Draws raw stroke lines. `snap` is the value of pencil.snap, "" for the default.
Result<SnapCount> draw_lines(const std::string& ndjson, const SnapHand& hand,
                             const std::string& snap = "");

/// The paths of raw stroke lines.
std::vector<std::vector<Point>> paths_of(const std::string& ndjson);

/// Number of shapes that were drawn to within 1.5 mm of a closed one (of four lines: 0.8 mm at each
/// corner), to within 0.8 mm where a line goes on with the next, and in about the size that was
/// meant: a very light hand squeezes a circle of 3 mm flat. `drawn` is what came without snapping.
int shapes_drawn(const SnapCount& drawn, const std::vector<std::vector<Point>>& meant,
                 int lines_per_shape);

/// Number of single lines that meet themselves as they were recorded: closed shapes.
int shapes_meant(const std::vector<std::vector<Point>>& meant);

/// Number of shapes that closed: a closed stroke, or four lines that share their ends.
int shapes_closed(const SnapCount& count, int lines_per_shape);

/// Number of ends that lie exactly on another stroke, which only snapping does, although without
/// snapping, in `off`, they were more than 0.8 mm from it. Requires that no strokes were joined, so
/// that the strokes of both agree by number.
int ends_met_unasked(const SnapCount& count, const SnapCount& off);

/// The strokes as the simulated writing hand draws them.
std::string lines_of(const SnapScene& scene, std::uint64_t seed = 1);

}  // namespace felt::snap_test
