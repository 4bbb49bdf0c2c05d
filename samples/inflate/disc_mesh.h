#pragma once

#include <array>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "felt/base/result.h"
#include "felt/geometry/point.h"

/// A triangle mesh that fills an outline. The first points are those of the outline, in order; the
/// others are inside. No inner edge connects two points of the outline, so if you move the inner
/// points off the plane, up for one side and down for the other, you get a closed surface.
class DiscMesh {
 public:
  using Triangle = std::array<int, 3>;

  /// Fills an outline; edges become about `step_mm` long. Fails if there are fewer than three
  /// different points, or if the outline crosses or touches itself.
  static felt::Result<DiscMesh> fill(std::span<const felt::Point> outline, double step_mm);

  [[nodiscard]] const std::vector<felt::Point>& points() const { return points_; }
  /// Returns the triangles, all oriented from +x to +y.
  [[nodiscard]] const std::vector<Triangle>& triangles() const { return triangles_; }
  [[nodiscard]] int outline_count() const { return outline_count_; }

 private:
  using Edge = std::pair<int, int>;  // from, to

  bool clip_ears();
  void add_grid(double step_mm);
  void add_inside(felt::Point p);
  void split_chords();
  void set(int triangle, int a, int b, int c);
  void add(int a, int b, int c);
  void make_delaunay(std::vector<Edge> suspects);
  [[nodiscard]] bool is_ear(const std::vector<int>& ring, std::size_t k) const;
  [[nodiscard]] int across(int triangle, Edge edge) const;

  std::vector<felt::Point> points_;
  std::vector<Triangle> triangles_;
  std::map<Edge, int> at_;  // directed edge -> the triangle on that side of it
  int outline_count_ = 0;
};
