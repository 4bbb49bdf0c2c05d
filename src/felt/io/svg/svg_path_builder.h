#pragma once

#include <cstddef>
#include <vector>

#include "felt/geometry/cubic.h"

namespace felt {

/// A sequence of joined cubics of a path: 3 n + 1 points, n >= 1. The control points of a straight
/// line divide it into thirds. A closed contour ends exactly at its first point.
struct SvgContour {
  std::vector<Point> points;
  bool closed = false;

  [[nodiscard]] std::size_t segment_count() const noexcept { return points.size() / 3; }
  [[nodiscard]] Cubic segment(std::size_t i) const noexcept {
    const Point* p = &points[3 * i];
    return Cubic{{p[0], p[1], p[2], p[3]}};
  }
};

/// Builds contours from drawing commands like those of SVG path data. All commands are converted to
/// cubics.
class SvgPathBuilder {
 public:
  /// Accepts at most `max_segments` segments. Further commands are ignored and set `full`.
  explicit SvgPathBuilder(std::size_t max_segments) noexcept : room_(max_segments) {}

  void move(Point p);
  void line(Point p);
  void cubic(Point a, Point b, Point p);
  void quadratic(Point control, Point p);
  /// Adds an elliptical arc as up to four cubics, by the centre parameterisation of SVG 1.1 F.6:
  /// radii that are too small are scaled up, and a zero radius makes a line.
  void arc(double rx, double ry, double turn_deg, bool large, bool sweep, Point p);
  /// Closes the contour. The next command begins at the start of the closed contour.
  void close();

  [[nodiscard]] Point here() const noexcept { return here_; }
  [[nodiscard]] bool full() const noexcept { return full_; }
  /// Returns the contours. A move makes no contour unless a line, a curve or close() follows it.
  std::vector<SvgContour> take();

 private:
  bool begin_segment();

  std::vector<SvgContour> contours_;
  Point here_, begin_;
  std::size_t room_;
  bool open_ = false;   ///< the last contour continues
  bool moved_ = false;  ///< the last command was a move
  bool full_ = false;
};

}  // namespace felt
