#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "felt/base/result.h"
#include "felt/document/edit.h"
#include "felt/geometry/point.h"

namespace felt {

/// The kinds of guides that a drawing can have. For each kind, the comment names the fields of
/// DrawingGuide that it uses besides `origin` and `strength`; angles count from +x towards +y.
/// `axes` counts mirror axes: one axis gives two images (a mirror), n axes give 2n images, as the
/// dihedral group of that order. (Krita and Procreate name the numbers of images or segments.)
enum class DrawingGuideKind : std::uint8_t {
  kRuler,        ///< a straight edge from `origin`: `angle_rad`, `size_mm` (length)
  kLine,         ///< one infinite line through `origin`: `angle_rad`
  kParallels,    ///< all lines of one direction: `angle_rad`
  kSetSquare,    ///< a right angle at `origin`: `angle_rad`, legs `size_mm` and `second_mm`
  kProtractor,   ///< rays from `origin` at multiples of `step_rad`: `angle_rad`, `size_mm` (radius)
  kCompass,      ///< circles around `origin`; the pen chooses the radius where it touches
  kEllipse,      ///< `angle_rad`, semi-axes `size_mm` and `second_mm`
  kEllipses,     ///< all ellipses with the centre, direction and proportions of kEllipse
  kPerspective,  ///< lines to the `points`: one to three vanishing points
  kGrid,         ///< nodes of squares: `angle_rad`, `size_mm` (spacing)
  kIsometricGrid,  ///< nodes of equilateral triangles: `angle_rad`, `size_mm` (spacing)
  kSymmetry,       ///< `axes` mirror axes through `origin`: `angle_rad` (the first axis)
  kTrace,          ///< the centre line of the stroke `stroke`, also after it was edited
  kTeacher,        ///< a recorded path: `points`, `times_ms`
};

/// A guide of a drawing: a shape to draw along, which holds the pen by a force and lets it go if
/// the user pulls harder (docs/design/forces.md#guides). Guides are not ink: exported files leave
/// them out. Immutable, like a stroke.
struct DrawingGuide {
  static constexpr int kMinAxes = 1, kMaxAxes = 16;
  static constexpr double kMaxCoordinateMm = 1e6;
  static constexpr double kMaxAngleRad = 1e3;
  static constexpr double kMinSizeMm = 0.5, kMaxSizeMm = 1e5;
  static constexpr double kMinStepRad = 0.017453292519943295;  ///< 1 degree
  static constexpr double kMaxStepRad = 1.5707963267948966;    ///< 90 degrees
  static constexpr std::size_t kMaxVanishingPoints = 3;
  static constexpr std::size_t kMaxTeacherPoints = 20'000;

  DrawingGuideKind kind = DrawingGuideKind::kRuler;
  Point origin{};
  double angle_rad = 0.0;
  double size_mm = 100.0;
  double second_mm = 60.0;
  double step_rad = 0.2617993877991494;  ///< 15 degrees
  int axes = kMinAxes;
  StrokeId stroke{};
  std::vector<Point> points = {};     ///< mm
  std::vector<double> times_ms = {};  ///< for kTeacher: when the teacher was at each point
  double strength = 1.0;              ///< 0..1, multiplies the force

  friend bool operator==(const DrawingGuide&, const DrawingGuide&) = default;
};

inline constexpr std::size_t kDrawingGuideKinds = 14;
/// Largest number of guides of a drawing, because each touch looks at all of them.
inline constexpr std::size_t kMaxDrawingGuides = 256;

/// Returns the name of a kind in events: "ruler", "isometric-grid".
std::string_view guide_kind_name(DrawingGuideKind kind) noexcept;

/// Checks the invariants of a guide: every number is finite and within the limits above, `strength`
/// is 0 to 1; only kPerspective has vanishing points, one to three of them; only kTeacher has a
/// path, of 2 to kMaxTeacherPoints points with one time each, which start at 0 or later and do not
/// decrease; and only kTrace names a stroke. Whether the document has this stroke is not checked: a
/// trace of a missing stroke has no effect. All readers call this. The message starts with the key
/// of the event (docs/formats/events.md).
Result<void> check_drawing_guide(const DrawingGuide& guide);

}  // namespace felt
