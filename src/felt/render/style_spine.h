#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "felt/stroke/outline/outline.h"

namespace felt {

struct StyledRow;

/// A point of a spine.
struct SpinePoint {
  Point center;
  double radius = 0.0;
  double tone = 0.0;
  Vec normal;           ///< unit vector to the right of the path (y of a shape)
  double along = 0.0;   ///< distance from the start, in widths of the line
  double length = 0.0;  ///< distance from the start, in the unit of the row
};

/// The centre line of a stroke, to which styles are fitted: positions along it are measured in
/// widths of the line. Where the path bends by more than 60 degrees, it has several points at the
/// same position, whose normals turn from that before to that after the bend. If the seam of a
/// closed line is such a bend, its first half is at the end and its second half at the start.
/// Reuses its buffers.
class Spine {
 public:
  /// Largest number of points, unless the row itself has more dabs.
  static constexpr std::size_t kMaxPoints = std::size_t{1} << 14;
  /// Corners whose directions have a larger scalar product (30 degrees) do not divide a line: a
  /// fast or shaking hand makes many small ones.
  static constexpr double kBlunt = 0.866;

  /// Replaces the spine. Adjacent points are at most `max_step` widths apart, unless this needs
  /// more than kMaxPoints.
  void build(const StyledRow& row, double max_step);

  [[nodiscard]] std::span<const SpinePoint> points() const noexcept { return points_; }
  /// Returns the positions of the declared corners that turn by at least 30 degrees, ascending. A
  /// corner at the seam of a closed line is at 0.
  [[nodiscard]] std::span<const double> corners() const noexcept { return corners_; }
  [[nodiscard]] bool closed() const noexcept { return closed_; }
  /// Returns the length of the line, in widths.
  [[nodiscard]] double end() const noexcept { return points_.empty() ? 0.0 : points_.back().along; }

  /// Returns the index of the first point beyond this position, at most points().size().
  [[nodiscard]] std::size_t next(double along) const noexcept;
  /// Returns the point at this position, which is clamped to the line: of several points, the last.
  /// Requires a point.
  [[nodiscard]] SpinePoint at(double along) const noexcept;
  /// Returns the index of the first point that is not before this position, at most
  /// points().size().
  [[nodiscard]] std::size_t first(double along) const noexcept;
  /// Returns the index of the point where a shape may begin or end at this position: of several
  /// points, the one in the middle of the bend. Nullopt if no point is exactly there.
  [[nodiscard]] std::optional<std::size_t> joint(double along) const noexcept;

 private:
  /// A dab of the row, or one between two of them.
  struct Knot {
    Dab dab;
    bool is_corner = false;
    double mark = -1.0;  ///< RowMark::along, or below 0
    double along = 0.0;
  };

  void add_knots(const StyledRow& row, double max_step);
  void add_knot(const Knot& knot, int steps);
  void measure();
  void add_points(double side, bool has_marks);
  [[nodiscard]] std::pair<Vec, Vec> normals(std::size_t knot, double side) const noexcept;
  void add_bend(std::size_t knot, SpinePoint p, Vec after);
  void add_turn(SpinePoint p, Vec normal, double turn);

  std::vector<Knot> knots_;
  std::vector<SpinePoint> points_;
  std::vector<double> corners_;
  bool closed_ = false;
};

/// Returns the length of the line between two dabs, in widths of the line, which change linearly.
double length_in_widths(const Dab& a, const Dab& b) noexcept;

/// Returns the position at `y` widths to the right of a point of a spine.
inline Point beside(const SpinePoint& p, double y) noexcept {
  return p.center + 2.0 * p.radius * y * p.normal;
}

}  // namespace felt
