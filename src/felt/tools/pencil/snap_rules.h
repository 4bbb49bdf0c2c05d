#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "felt/document/stroke_index.h"
#include "felt/tools/scene.h"

namespace felt {

/// Rules that distinguish a line that is meant to meet another one from a line that only comes near
/// it (docs/decisions/0011-when-a-line-snaps.md). The rules are pure functions of the document.
namespace snap_rules {

/// Maximum turn at a joint, degrees. If the turn would be larger, ends are not joined: at
/// neighbouring lines of a hatching the turn would be 180 degrees, but at the corners of a
/// five-pointed star it is only 144.
inline constexpr double kFoldDeg = 150.0;
/// If the turn is larger than this, ends are joined only within kSharpRadiusMm, because the lines
/// of a hatching are not exactly parallel and are shaky.
inline constexpr double kSharpDeg = 115.0;
inline constexpr double kSharpRadiusMm = 0.5;
/// Shorter strokes are dots. Their ends have no direction.
inline constexpr double kDotMm = 1.5;
/// An end belongs to a hatching if another end is within this distance of it.
inline constexpr double kCrowdMm = 3.2;
/// Ends within this distance count as one point.
inline constexpr double kSameMm = 0.3;
/// Distance over which the direction of an end is measured.
inline constexpr double kInwardMm = 1.5;

/// Returns true if the diagonal of the control points' bounding box is shorter than kDotMm.
bool is_dot(const Stroke& stroke) noexcept;

/// Returns the unit direction from an end into its stroke.
Vec inward_direction(const Stroke& stroke, StrokeTip tip) noexcept;

/// Returns true if ink that arrives `gap_mm` away from the end in the direction `heading` would
/// turn back along the stroke instead of continuing it.
bool turns_back(const Stroke& stroke, StrokeTip tip, Vec heading, double gap_mm) noexcept;

/// Returns true if an end of another stroke lies next to this end, as in a hatching.
/// `friend_stroke` and strokes that share an end with the stroke of `tip` are ignored.
bool is_crowded(const Scene& scene, const TipHit& tip, StrokeId friend_stroke);

/// The first point at which a ray meets an editable stroke.
struct RayHit {
  StrokeId stroke;
  Point point;
  double distance_mm = 0.0;
  double angle_deg = 0.0;  ///< between ray and stroke, 0..90
  int hits = 0;            ///< number of points where the ray meets strokes, including this one
};
std::optional<RayHit> first_hit(const Scene& scene, Point from, Vec direction, double length_mm);

/// A stroke that the pen crossed, and its first and last crossing.
struct Crossed {
  StrokeId stroke;
  Point first, last;
};
/// A crossing within this distance of an end is part of the corner at that end.
inline constexpr double kCornerMm = 2.0;

/// Adds the strokes that the straight line from a to b meets to `crossed`, which contains each
/// stroke once. Returns true if the line meets any stroke.
bool append_crossed(const Scene& scene, Point a, Point b, std::vector<Crossed>& crossed);

/// Returns true if the stroke was crossed anywhere but near its end at `tip`. A line that is drawn
/// over another line is meant to darken that line, not to continue it.
bool is_drawn_over(const std::vector<Crossed>& crossed, StrokeId stroke, Point tip) noexcept;

}  // namespace snap_rules
}  // namespace felt
