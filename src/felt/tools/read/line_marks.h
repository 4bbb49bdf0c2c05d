#pragma once

#include <optional>
#include <vector>

#include "felt/document/stroke_index.h"
#include "felt/tools/read/read_options.h"
#include "felt/tools/scene.h"

namespace felt {

/// A position of a line at which something changes: it ends, or meets other lines.
struct LineMark {
  Point at{};
  std::size_t lines = 1;  ///< lines that meet here; 1: an end. A loop counts twice at its crossing

  friend bool operator==(const LineMark&, const LineMark&) = default;
};

/// Marks that are nearer to each other than this are one.
inline constexpr double kOneMarkMm = 1.5;

/// Returns true if the tool reads this stroke: its layer is visible and, if `layers` says so,
/// current.
bool is_read(const Scene& scene, StrokeId id, ReadLayers layers);

/// Returns the point on a line that the tool reads nearest to `pen`, or nullopt if there is none
/// within radius_mm.
std::optional<StrokeHit> nearest_read(const Scene& scene, Point pen, double radius_mm,
                                      ReadLayers layers);

/// Returns the distance from `pen` to this stroke, or nullopt if it is larger than radius_mm.
std::optional<double> distance_to(const Scene& scene, StrokeId id, Point pen, double radius_mm);

/// Returns the ends of a line, its crossings, and the points at which other lines end on it, within
/// a square of 2 `reach_mm` around `pen`. Lines meet if their ink touches. Looks at no more than
/// kMaxOwnPieces segments of the line and kMaxOtherPieces of other lines, so that its time is
/// bounded in dense drawings: the first ones in the order of ids.
std::vector<LineMark> marks_near(const Scene& scene, StrokeId id, Point pen, double reach_mm,
                                 ReadLayers layers);
inline constexpr std::size_t kMaxOwnPieces = 24;
inline constexpr std::size_t kMaxOtherPieces = 64;

}  // namespace felt
