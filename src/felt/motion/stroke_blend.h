#pragma once

#include <optional>
#include <vector>

#include "felt/base/result.h"
#include "felt/motion/similarity.h"
#include "felt/stroke/stroke.h"

namespace felt {

/// The control polygon of a stroke between two key drawings, as the lengths and directions of its
/// edges. Keep it to reuse its buffers.
struct BlendPose {
  Point start, end;
  std::vector<double> lengths;  ///< of three edges for each segment, in mm
  std::vector<Vec> directions;  ///< unit vectors
};

/// The shape between two strokes (docs/design/motion.md#interpolation). The control polygons of
/// both are cut into edges that correspond to each other, and the lengths and the turns of the
/// edges are interpolated, not the positions: Sederberg, Gao, Wang and Mu, "2-D shape blending: an
/// intrinsic solution to the vertex path problem", 1993, doi:10.1145/166117.166118. So a part that
/// turns keeps its shape, and no turn leaves the range between its values in both strokes: nothing
/// flips.
///
/// Immutable; several threads may use one object, each with its own pose.
class StrokeBlend {
 public:
  /// Requires that the strokes run in the same direction and, if both are closed, that their seams
  /// correspond. If only one is closed, it counts as an open stroke whose ends touch. `motion` is
  /// that of the whole drawing; the stroke turns with it, and its centre moves along with it.
  StrokeBlend(const Stroke& a, const Stroke& b, const Similarity& motion);

  /// Returns true if the strokes between are closed: both strokes are.
  [[nodiscard]] bool closed() const noexcept { return closed_; }
  /// Sets `pose` to the shape at t, 0..1, at its own place. A closed shape is closed.
  void pose(double t, BlendPose& pose) const;
  /// Moves the ends of an open pose to these positions. If both are given, turns and scales the
  /// shape, within limits, and then changes the lengths of its edges, but not their directions. If
  /// even that does not suffice, both ends miss their positions by the same distance.
  static void fit_ends(BlendPose& pose, std::optional<Point> start, std::optional<Point> end);
  /// Returns the stroke at t with the shape of `pose`: widths, tones and the colour are
  /// interpolated, and the medium changes at t = 0.5. Fails only if the shape is not finite.
  [[nodiscard]] Result<Stroke> stroke(double t, const BlendPose& pose) const;

  /// Returns the parameter of the stroke at any t at a parameter of the first or the second stroke.
  [[nodiscard]] double parameter_of_a(double u) const noexcept;
  [[nodiscard]] double parameter_of_b(double u) const noexcept;
  /// Returns the position at a parameter of a pose, as the stroke has it.
  static Point position(const BlendPose& pose, double v) noexcept;

 private:
  struct Edge {
    double a_mm = 0.0, b_mm = 0.0;  // b_mm without the scaling of the motion
    double angle_rad = 0.0;         // in the first stroke
    double turn_rad = 0.0;          // from the first to the second stroke
  };
  struct Knot {
    double v = 0.0;
    WidthKnot a, b;
  };

  void add_edges(const Stroke& a, const Stroke& b);
  void unwrap(const std::vector<bool>& is_smooth);
  void add_knots(const Stroke& a, const Stroke& b);
  void set_look(const Stroke& a, const Stroke& b);

  bool closed_ = false;
  Similarity motion_;
  Point a_centre_, b_centre_;
  std::vector<Edge> edges_;
  std::vector<JointKind> joints_;
  std::vector<double> a_u_, b_u_;  // at the ends of the pieces
  std::vector<Knot> knots_;
  std::string a_medium_, b_medium_;
  Rgba a_color_, b_color_;
};

/// Returns the colour between two colours; t is 0..1. Channels are weighted by their alpha.
Rgba blended(Rgba a, Rgba b, double t) noexcept;

}  // namespace felt
