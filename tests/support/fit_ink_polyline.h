#pragma once

#include <vector>

#include "tests/support/fit_box_tree.h"

namespace fit_check {

/// The samples of a stroke, joined by straight lines. Repeated samples count once.
class InkPolyline {
 public:
  explicit InkPolyline(const std::vector<Point>& samples);

  /// Returns the samples without repeats. A line joins each sample to the next.
  [[nodiscard]] const std::vector<Point>& vertices() const { return vertices_; }

  /// Returns the indices of the lines, the longest line first. Line i goes from vertex i to the
  /// next.
  [[nodiscard]] const std::vector<std::size_t>& edges_by_length() const { return by_length_; }

  /// The result of a search for the nearest point of the polyline.
  struct Nearest {
    double distance = 0.0;
    /// Length of the longest line that contains the nearest point: the distance between the samples
    /// there.
    double gap = 0.0;
  };
  /// Returns the point of the polyline nearest to p. `hint` is the index of the line to try first;
  /// it is set to the index of the nearest line.
  [[nodiscard]] Nearest nearest(Point p, std::size_t& hint) const;

  /// The turn of the ink at the samples near a point.
  struct Turn {
    double degrees = 0.0;
    bool short_arm = false;  ///< the ink ends within half an arm
  };
  /// Returns the largest turn of the ink at any sample within `radius` of p, and whether this turn
  /// has a short arm. If no sample is within `radius`, uses the ends of the nearest line. The turn
  /// at a sample q is the angle between q - A and B - q. A and B are the first points of the ink,
  /// backwards and forwards from q, that are `arm` away from q, or the ends of the ink. If very
  /// many samples are near, because the pen rested there, only about 64 of them are tried.
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
