#pragma once

#include <cstddef>
#include <optional>

#include "felt/stroke/stroke.h"

namespace felt {

/// How the drawn width or tone of a piece of ink differs from the straight line between its ends:
///   x (1 - x) ((1 - x) start - x end),  x = 0..1 along the piece.
/// The difference is 0 at both ends. There, `start` and `end` are its derivatives with respect to
/// x, so line and difference together are the cubic with these values and derivatives.
struct ProfileBend {
  double start = 0.0, end = 0.0;

  [[nodiscard]] constexpr bool is_straight() const noexcept { return start == 0.0 && end == 0.0; }
  [[nodiscard]] constexpr double at(double x) const noexcept {
    return x * (1.0 - x) * ((1.0 - x) * start - x * end);
  }
  [[nodiscard]] constexpr double derivative(double x) const noexcept {
    return start * (1.0 - x) * (1.0 - 3.0 * x) - end * x * (2.0 - 3.0 * x);
  }
  [[nodiscard]] constexpr double second_derivative(double x) const noexcept {
    return start * (6.0 * x - 4.0) + end * (6.0 * x - 2.0);
  }
  /// Returns the bend of the same piece in the opposite direction.
  [[nodiscard]] constexpr ProfileBend reversed() const noexcept { return {-end, -start}; }
  /// Returns the number of equal steps of x, at least `least` >= 1, between which straight lines
  /// are within the tolerance of the bend.
  [[nodiscard]] int steps(double tolerance, int least) const noexcept;
};

/// A part of a segment between neighbouring nodes. The joints and the width breakpoints are nodes.
struct DrawnPiece {
  int segment = 0;
  double t0 = 0.0, t1 = 1.0;
  /// The index of the breakpoint at or before the piece; the next one is at or behind it.
  std::size_t knot = 0;
  ProfileBend radius_mm, tone;
};

/// Largest change of the radius per length at a node that is not smoothed: the edge of the ink
/// turns by half a degree, which nobody sees.
inline constexpr double kUnseenKink = 0.0087;
/// A piece whose radius grows or shrinks at least this much per length is a jump: one end of it
/// inks all of it, so that it has no edge. Its nodes are not smoothed.
inline constexpr double kJump = 1.0;
/// Largest change of the tone per mm at a node that is not smoothed.
inline constexpr double kUnseenToneKink = 0.02;

/// A piece by equation (3): its changes from start to end, and the speeds at which its ends pass.
struct ProfileLine {
  DrawnPiece piece;
  double radius_mm = 0.0, tone = 0.0;
  double speed0_mm = 0.0, speed1_mm = 0.0;  ///< mm per piece
};

/// Sets the bends of two neighbouring pieces at the node between them. If a speed is 0, the slope
/// per mm has no meaning, and the kink stays.
void smooth_node(ProfileLine& before, ProfileLine& after) noexcept;

/// Walks along the profile that is drawn (docs/decisions/0013-widths-are-drawn-smooth.md). It has
/// the width and tone of equation (3) at every node, is monotonic between nodes, and has no visible
/// kink beside jumps: the slope per length at a node is the harmonic mean of the slopes of equation
/// (3) on both sides, or 0 if the width has an extreme there. This is the interpolation of Butland,
/// "A method of interpolating reasonable-shaped curves through any data", 1980; it is monotonic by
/// theorem 1 of Fritsch and Carlson, "Monotone piecewise cubic interpolation", 1980, because no
/// slope is more than three times that of the straight line.
///
/// A piece without a visible kink at either end has bends of exactly 0. The bends of a piece depend
/// only on this piece and its two neighbours. Requires that the stroke outlives this object.
class DrawnProfile {
 public:
  /// Starts before the first piece of segment `first`, 0 <= first < segment_count().
  explicit DrawnProfile(const Stroke& stroke, int first = 0) noexcept;

  /// Returns the next piece, or nullptr after the last one of the stroke. The piece is valid until
  /// the next call.
  const DrawnPiece* next() noexcept;

 private:
  [[nodiscard]] ProfileLine line(int segment, double t0, double t1,
                                 std::size_t knot) const noexcept;
  [[nodiscard]] ProfileLine line_from(int segment, double t0, std::size_t knot) const noexcept;
  bool find_after(const ProfileLine& before) noexcept;
  [[nodiscard]] std::optional<ProfileLine> line_before(const ProfileLine& after) const noexcept;
  [[nodiscard]] bool is_seam_smooth() const noexcept;

  const Stroke& stroke_;
  ProfileLine now_, ahead_;
  bool has_ahead_ = true;
};

/// Returns the drawn width at u, clamped to [0, n]; Stroke::width_mm returns that of equation (3).
double drawn_width_mm(const Stroke& stroke, double u) noexcept;

}  // namespace felt
