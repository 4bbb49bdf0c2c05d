#pragma once

#include <optional>
#include <span>

#include "felt/geometry/point.h"

namespace felt {

/// A motion of the page without mirroring: it turns by `angle_rad`, scales by `scale` > 0, and
/// moves the point `from` to `to`. Unlike an affine map, it can be done in part, and it can turn by
/// more than half a turn.
struct Similarity {
  Point from{}, to{};
  double angle_rad = 0.0;
  double scale = 1.0;

  friend constexpr bool operator==(const Similarity&, const Similarity&) noexcept = default;
};

/// Returns the image of p after the part t of the motion, 0..1: `from` has moved along a straight
/// line, the angle has grown linearly and the scale geometrically. t = 0 gives p, up to rounding.
Point moved(const Similarity& motion, Point p, double t = 1.0) noexcept;

/// Returns the image of a displacement after the part t of the motion.
Vec moved(const Similarity& motion, Vec v, double t = 1.0) noexcept;

/// Returns the point that the whole motion moves to p.
Point moved_back(const Similarity& motion, Point p) noexcept;

/// Returns the position at t of a point that is at `a` at t = 0 and at `b` at t = 1: the motion
/// carries it, and what the motion leaves over grows linearly. Exact at both ends up to rounding.
Point carried(const Similarity& motion, Point a, Point b, double t) noexcept;

/// A point and its image, with a weight of at least 0.
struct PointPair {
  Point from, to;
  double weight = 1.0;
};

/// Returns the similarity with the smallest weighted sum of squared distances between moved `from`
/// points and `to` points (Umeyama, 1991, doi:10.1109/34.88573, for the plane and without
/// mirroring). Returns nullopt if the points have no extent or no weight.
std::optional<Similarity> fit_similarity(std::span<const PointPair> pairs) noexcept;

/// Does the same, but reduces the weight of pairs that do not fit (Tukey's biweight at 4.685 robust
/// standard deviations; Holland and Welsch, 1977, doi:10.1080/03610927708827533), starting from
/// `start`. Changes the weights of `pairs`.
Similarity fit_robust_similarity(std::span<PointPair> pairs, const Similarity& start) noexcept;

}  // namespace felt
