#pragma once

#include <vector>

#include "tests/support/fit_box_tree.h"

namespace fit_check {

/// The ink as it was sampled: the samples joined by straight lines, repeated ones taken once.
class InkPolyline {
 public:
  explicit InkPolyline(const std::vector<Point>& samples);

  /// The samples without repeats; consecutive ones are joined by the lines.
  [[nodiscard]] const std::vector<Point>& vertices() const { return vertices_; }

  /// Lines, the longest first; line i goes from vertex i to the next.
  [[nodiscard]] const std::vector<std::size_t>& edges_by_length() const { return by_length_; }

  /// Where the polyline comes nearest to a place.
  struct Nearest {
    double distance = 0.0;
    /// Length of the longest line that touches the nearest point: how far apart the samples are
    /// there.
    double gap = 0.0;
  };
  /// `hint` is a line index to begin with; it becomes the nearest line.
  [[nodiscard]] Nearest nearest(Point p, std::size_t& hint) const;

  /// How the ink turns at the samples near a place.
  struct Turn {
    double degrees = 0.0;
    bool short_arm = false;  ///< the ink ends nearer than half an arm
  };
  /// The largest turn of the ink at any sample within `radius` of p (at the nearest line's ends
  /// when there is none), and whether that one has a short arm. The turn at a sample q is the angle
  /// between q - A and B - q, where A and B are the places where the ink, followed backwards and
  /// forwards from q, first gets `arm` away from q; an arm that meets the ink's end stops there.
  /// Where a pen has rested there may be thousands of samples; then every k-th is tried, 64 or so.
  [[nodiscard]] Turn turn_near(Point p, double radius, double arm) const;

 private:
  static constexpr std::size_t kMaxVerticesTried = 64;

  [[nodiscard]] std::vector<std::size_t> vertices_near(Point p, double radius) const;
  [[nodiscard]] Point follow(std::size_t from, std::ptrdiff_t step, double arm) const;
  [[nodiscard]] Turn turn_at(std::size_t vertex, double arm) const;
  [[nodiscard]] double edge_length(std::size_t edge) const;

  std::vector<Point> vertices_;
  BoxTree edges_;
  std::vector<std::size_t> by_length_;
};

}  // namespace fit_check
