#include "felt/motion/group_motion.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "felt/base/constants.h"
#include "felt/geometry/rect.h"

namespace felt {
namespace {

/// The strokes of `a` from which hypotheses are made, the similar strokes tried for each of them,
/// and the strokes with which a hypothesis is tested.
constexpr std::size_t kSeeds = 16, kPartners = 5, kTested = 64;
/// Nothing is closer than this share of the diagonal, and everything farther away is equally far.
constexpr double kFarShare = 0.12;
/// Larger changes of size are not the motion of a drawing.
constexpr double kMaxScaling = 3.0;
/// How much of the error a turn by half and a scaling by e are worth.
constexpr double kTurnPrice = 0.06, kScalePrice = 0.06;

std::vector<std::size_t> longest_first(std::span<const StrokeShape> shapes, std::size_t count) {
  std::vector<std::size_t> order(shapes.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t i, std::size_t k) {
    return shapes[i].length_mm > shapes[k].length_mm;
  });
  order.resize(std::min(order.size(), count));
  return order;
}

/// Returns the similarity that fits the points of one shape to those of another, in one direction.
std::optional<Similarity> fit_of(const StrokeShape& a, const StrokeShape& b, bool reversed) {
  std::array<PointPair, kShapePoints> pairs;
  for (std::size_t i = 0; i < kShapePoints; ++i) {
    pairs[i] = {a.points[i], b.points[reversed ? kShapePoints - 1 - i : i]};
  }
  return fit_similarity(pairs);
}

/// A motion of one stroke of `a` onto one of `b`, and what it leaves over, relative to the length.
struct StrokeFit {
  double error = 0.0;
  Similarity motion;
};

void append_fits(const StrokeShape& a, std::span<const StrokeShape> b,
                 std::vector<Similarity>& hypotheses) {
  std::vector<StrokeFit> fits;
  for (const StrokeShape& other : b) {
    if (std::fabs(std::log(other.length_mm / a.length_mm)) > std::log(kMaxScaling)) continue;
    for (const bool reversed : {false, true}) {
      const auto motion = fit_of(a, other, reversed);
      if (!motion || std::fabs(std::log(motion->scale)) > std::log(kMaxScaling)) continue;
      double sum = 0.0;
      for (std::size_t i = 0; i < kShapePoints; ++i) {
        sum += distance(moved(*motion, a.points[i]),
                        other.points[reversed ? kShapePoints - 1 - i : i]);
      }
      // Prefers strokes that have not changed their length.
      const double scaling = std::fabs(std::log(motion->scale));
      fits.push_back({sum / (other.length_mm * kShapePoints) + 0.1 * scaling, *motion});
    }
  }
  const std::size_t kept = std::min(fits.size(), 2 * kPartners);
  std::partial_sort(fits.begin(), fits.begin() + static_cast<std::ptrdiff_t>(kept), fits.end(),
                    [](const StrokeFit& x, const StrokeFit& y) { return x.error < y.error; });
  for (std::size_t i = 0; i < kept; ++i) hypotheses.push_back(fits[i].motion);
}

Point centre_of(std::span<const StrokeShape> shapes) {
  Vec sum{};
  double weight = 0.0;
  for (const StrokeShape& shape : shapes) {
    sum += shape.length_mm * (shape.centre - Point{});
    weight += shape.length_mm;
  }
  return Point{} + sum / weight;
}

/// Returns how far two shapes are from each other: the mean distance of three points of them.
double coarse_distance(const StrokeShape& a, const StrokeShape& b) noexcept {
  const double middle = distance(a.centre, b.centre);
  if (a.closed || b.closed) return middle;
  const Point a0 = a.points.front(), a1 = a.points.back(), b0 = b.points.front(),
              b1 = b.points.back();
  const double same = distance(a0, b0) + distance(a1, b1);
  const double other = distance(a0, b1) + distance(a1, b0);
  return (middle + std::min(same, other)) / 3.0;
}

double score_of(const Similarity& motion, std::span<const StrokeShape> tested,
                std::span<const StrokeShape> b, double far_mm, double best) {
  double weights = 0.0, total = 0.0;
  for (const StrokeShape& shape : tested) weights += std::sqrt(shape.length_mm);
  double price = kTurnPrice * std::fabs(motion.angle_rad) / std::numbers::pi +
                 kScalePrice * std::fabs(std::log(motion.scale));
  for (const StrokeShape& shape : tested) {
    const StrokeShape there = moved(motion, shape);
    double least = 1.0;
    for (const StrokeShape& other : b) {
      const double error = coarse_distance(there, other) / far_mm;
      if (error >= least) continue;
      least = std::min(least, error + 0.3 * std::fabs(std::log(there.length_mm / other.length_mm)));
    }
    total += std::sqrt(shape.length_mm) * least;
    if (price + total / weights >= best) break;
  }
  return price + total / weights;
}

}  // namespace

StrokeShape moved(const Similarity& motion, const StrokeShape& shape) noexcept {
  StrokeShape result = shape;
  const double c = motion.scale * std::cos(motion.angle_rad),
               s = motion.scale * std::sin(motion.angle_rad);
  const auto image = [&](Point p) {
    const Vec v = p - motion.from;
    return motion.to + Vec{c * v.x - s * v.y, s * v.x + c * v.y};
  };
  for (Point& p : result.points) p = image(p);
  result.centre = image(shape.centre);
  result.length_mm *= motion.scale;
  return result;
}

double diagonal_mm(std::span<const StrokeShape> shapes) noexcept {
  Rect box;
  for (const StrokeShape& shape : shapes) {
    for (const Point p : shape.points) box.extend(p);
  }
  return box.empty() ? 0.0 : std::hypot(box.width(), box.height());
}

Similarity estimate_group_motion(std::span<const StrokeShape> a, std::span<const StrokeShape> b) {
  if (a.empty() || b.empty()) return {};
  const Point from = centre_of(a), to = centre_of(b);
  std::vector<Similarity> hypotheses{{from, from}, {from, to}};
  for (const std::size_t i : longest_first(a, kSeeds)) append_fits(a[i], b, hypotheses);
  std::vector<StrokeShape> tested;
  for (const std::size_t i : longest_first(a, kTested)) tested.push_back(a[i]);
  const double far_mm = std::max(kFarShare * std::max(diagonal_mm(a), diagonal_mm(b)), 0.5);
  Similarity best = hypotheses.front();
  double least = kInf;
  for (const Similarity& motion : hypotheses) {
    const double score = score_of(motion, tested, b, far_mm, least);
    if (score >= least) continue;
    least = score;
    best = motion;
  }
  return best;
}

}  // namespace felt
