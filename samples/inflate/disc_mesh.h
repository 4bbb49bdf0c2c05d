#pragma once

#include <array>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "felt/base/result.h"
#include "felt/geometry/point.h"

/// Triangles that fill an outline. The first points are the outline's, in order; the others lie
/// inside, and no inner edge joins two points of the outline: whoever lifts the inner points off
/// the plane, up for one side and down for the other, gets a closed surface.
class DiscMesh {
 public:
  using Triangle = std::array<int, 3>;

  /// Error: fewer than three different points, or an outline that crosses or touches itself.
  /// `step_mm` is about how long the edges become.
  static felt::Result<DiscMesh> fill(std::span<const felt::Point> outline, double step_mm);

  [[nodiscard]] const std::vector<felt::Point>& points() const { return points_; }
  /// All of them turn from +x to +y.
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
  std::map<Edge, int> at_;  // directed edge -> the triangle on its side
  int outline_count_ = 0;
};
