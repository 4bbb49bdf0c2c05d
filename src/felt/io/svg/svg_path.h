#pragma once

#include <cstddef>
#include <vector>

#include "felt/geometry/cubic.h"

namespace felt {

/// A run of joined cubics of a path: 3 n + 1 points, n >= 1. Straight lines have their handles at
/// thirds. A closed one ends at its first point, bit for bit.
struct SvgContour {
  std::vector<Point> points;
  bool closed = false;

  [[nodiscard]] std::size_t segment_count() const noexcept { return points.size() / 3; }
  [[nodiscard]] Cubic segment(std::size_t i) const noexcept {
    const Point* p = &points[3 * i];
    return Cubic{{p[0], p[1], p[2], p[3]}};
  }
};

/// Makes contours of drawing commands, as SVG's path data has them: everything becomes cubics.
class SvgPathBuilder {
 public:
  /// At most `most_segments`; commands beyond them are ignored and `full` says so.
  explicit SvgPathBuilder(std::size_t most_segments) noexcept : room_(most_segments) {}

  void move(Point p);
  void line(Point p);
  void cubic(Point a, Point b, Point p);
  void quadratic(Point control, Point p);
  /// An arc of an ellipse as up to four cubics, by the centre parameterisation of SVG 1.1 F.6:
  /// radii that do not reach are scaled up, a zero one makes a line.
  void arc(double rx, double ry, double turn_deg, bool large, bool sweep, Point p);
  /// Back to where this contour began; what follows begins there too.
  void close();

  [[nodiscard]] Point here() const noexcept { return here_; }
  [[nodiscard]] bool full() const noexcept { return full_; }
  /// The contours; moves that nothing followed are none.
  std::vector<SvgContour> take();

 private:
  bool begin_segment();

  std::vector<SvgContour> contours_;
  Point here_, begin_;
  std::size_t room_;
  bool open_ = false;   ///< whether the last contour goes on
  bool moved_ = false;  ///< whether the last command was a move
  bool full_ = false;
};

}  // namespace felt
