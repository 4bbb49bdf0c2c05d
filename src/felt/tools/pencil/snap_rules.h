#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "felt/document/stroke_index.h"
#include "felt/tools/scene.h"

namespace felt {

/// What tells a line that is meant to meet another from one that only comes near it
/// (docs/decisions/0011-when-a-line-snaps.md). Pure functions of the document.
namespace snap_rules {

/// An end turns back when the joined line would turn by more than this: neighbours in a hatching
/// turn by 180 degrees, the sharpest corner of a five-pointed star by 144.
inline constexpr double kFoldDeg = 150.0;
/// Beyond this the ends must nearly coincide, because hatching fans out and trembles.
inline constexpr double kSharpDeg = 115.0;
inline constexpr double kSharpRadiusMm = 0.5;
/// Shorter strokes are dots: their ends have no direction.
inline constexpr double kDotMm = 1.5;
/// Another end this near means that the end belongs to a hatching.
inline constexpr double kCrowdMm = 3.2;
/// Ends nearer than this share a point.
inline constexpr double kSameMm = 0.3;
/// Distance over which the direction of an end is measured.
inline constexpr double kInwardMm = 1.5;

/// True if the control points of the stroke lie within kDotMm.
bool is_dot(const Stroke& stroke) noexcept;

/// Unit direction from an end into its stroke.
Vec inward_direction(const Stroke& stroke, StrokeTip tip) noexcept;

/// True if ink that arrives at the end with direction `heading`, `gap_mm` away from it, would turn
/// back along the stroke instead of going on as one line.
bool turns_back(const Stroke& stroke, StrokeTip tip, Vec heading, double gap_mm) noexcept;

/// True if an end of a third stroke lies beside this one, as in a hatching. `friend_stroke` and
/// strokes that share a point with this one do not count.
bool is_crowded(const Scene& scene, const TipHit& tip, StrokeId friend_stroke);

/// Where the ray from `from` first meets a stroke that may be edited.
struct RayHit {
  StrokeId stroke;
  Point point;
  double distance_mm = 0.0;
  double angle_deg = 0.0;  ///< between ray and stroke, 0..90
  int hits = 0;            ///< places where the ray meets strokes, this one included
};
std::optional<RayHit> first_hit(const Scene& scene, Point from, Vec direction, double length_mm);

/// A stroke that the pen crossed, and where it did so first and last.
struct Crossed {
  StrokeId stroke;
  Point first, last;
};
/// A crossing this near to an end belongs to the corner that is drawn there.
inline constexpr double kCornerMm = 2.0;

/// Adds the strokes that the chord meets to a list without doubles. Returns true if it meets any.
bool append_crossed(const Scene& scene, Point a, Point b, std::vector<Crossed>& crossed);

/// True if the stroke was crossed elsewhere than near its end at `tip`: a line over another darkens
/// it and does not continue it.
bool is_drawn_over(const std::vector<Crossed>& crossed, StrokeId stroke, Point tip) noexcept;

}  // namespace snap_rules
}  // namespace felt
