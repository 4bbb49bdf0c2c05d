#pragma once

#include <optional>
#include <string>

#include "felt/base/result.h"
#include "felt/devices/simulated/person.h"
#include "felt/document/document.h"
#include "tests/drawing/snapping/snap_scenes.h"

namespace felt::snap_test {

/// The simulated hand that draws, and its device.
struct SnapHand {
  std::string name = "typical";  ///< name in simulated_hands()
  std::string device = "touch";
  bool forces = true;
  std::uint64_t tremor_seed = 0;  ///< 0 for only the tremor of WritingHand
  /// If set, this person draws instead of the hand, and corrects what the pen does (FeedbackHand).
  std::optional<Person> person = std::nullopt;
};

/// The result of a scene.
struct SnapCount {
  int meant = 0;    ///< strokes drawn
  int strokes = 0;  ///< strokes in the document
  int closed = 0;
  double mean_mm = 0.0;     ///< mean distance from the path that the hand meant to the ink
  std::vector<Stroke> ink;  ///< the strokes in drawing order

  /// Returns the number of strokes that became part of other strokes.
  [[nodiscard]] int joined() const { return meant - strokes; }
};

/// Draws the raw strokes of `ndjson`. `snap` is the value of pencil.snap, or "" for the default.
Result<SnapCount> draw_lines(const std::string& ndjson, const SnapHand& hand,
                             const std::string& snap = "");

/// Returns the paths of the raw strokes of `ndjson`.
std::vector<std::vector<Point>> paths_of(const std::string& ndjson);

/// Returns how many shapes are drawn well enough that they ought to close. The last line of such a
/// shape ends within 1.5 mm of its start (0.8 mm for a shape of four lines), each line starts
/// within 0.8 mm of the end of the previous one, and the size is about right: a very light hand
/// flattens a circle of 3 mm. `drawn` is the result without snapping.
int shapes_drawn(const SnapCount& drawn, const std::vector<std::vector<Point>>& meant,
                 int lines_per_shape);

/// Returns the number of single lines that are closed shapes as recorded: they end where they
/// start.
int shapes_meant(const std::vector<std::vector<Point>>& meant);

/// Returns the number of pairs of lines that are an outline as recorded, like the two lids of an
/// eye: both lines have the same ends, and their middles are apart.
int outlines_meant(const std::vector<std::vector<Point>>& meant);

/// Returns the number of closed shapes: closed strokes, or groups of four lines that share their
/// ends.
int shapes_closed(const SnapCount& count, int lines_per_shape);

/// Returns the number of ends that snapping moved onto another stroke by mistake: they lie exactly
/// on it, but without snapping (`off`) they were more than 0.8 mm away. Requires that no strokes
/// were joined, because strokes are compared by their index.
int ends_met_unasked(const SnapCount& count, const SnapCount& off);

/// Returns the strokes of `scene`, as the simulated writing hand draws them, as .ndjson text.
std::string lines_of(const SnapScene& scene, std::uint64_t seed = 1);

}  // namespace felt::snap_test
