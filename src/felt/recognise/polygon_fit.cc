#include "felt/recognise/polygon_fit.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "felt/geometry/polyline.h"
#include "felt/recognise/even_path.h"
#include "felt/recognise/round_fit.h"

namespace felt {
namespace {

/// Steps between the points of the arms with which a turn is measured, and the steps around a
/// corner that count as near it.
constexpr std::size_t kArm = 3, kNear = 4;

double turn_at(std::span<const Point> path, std::size_t i) noexcept {
  const std::size_t n = path.size();
  const Vec in = path[i] - path[(i + n - kArm) % n], out = path[(i + kArm) % n] - path[i];
  return std::abs(std::atan2(cross(in, out), dot(in, out)));
}

/// Sums of the coordinates up to each point, so that the squared distances of any run of points
/// from its line take constant time.
class RunSums {
 public:
  explicit RunSums(std::span<const Point> path) : sums_(path.size() + 1) {
    for (std::size_t i = 0; i < path.size(); ++i) {
      const Vec d = path[i] - path[0];
      sums_[i + 1] = sums_[i];
      Sum& s = sums_[i + 1];
      s.x += d.x;
      s.y += d.y;
      s.xx += d.x * d.x;
      s.xy += d.x * d.y;
      s.yy += d.y * d.y;
    }
  }
  /// Returns the sum for the points i..j, both included.
  [[nodiscard]] double squares(std::size_t i, std::size_t j) const noexcept {
    const Sum &a = sums_[i], &b = sums_[j + 1];
    const double n = static_cast<double>(j + 1 - i), x = b.x - a.x, y = b.y - a.y;
    const double xx = b.xx - a.xx - x * x / n, xy = b.xy - a.xy - x * y / n,
                 yy = b.yy - a.yy - y * y / n;
    return std::max(0.0, 0.5 * (xx + yy - std::hypot(xx - yy, 2.0 * xy)));
  }

 private:
  struct Sum {
    double x = 0.0, y = 0.0, xx = 0.0, xy = 0.0, yy = 0.0;
  };
  std::vector<Sum> sums_;
};

/// Returns the indices at which an open path is cut into `count` runs, with both ends. Neighbouring
/// runs share a point.
std::vector<std::size_t> best_cuts(std::span<const Point> path, std::size_t count) {
  const RunSums sums(path);
  const std::size_t n = path.size();
  constexpr double kNever = std::numeric_limits<double>::infinity();
  std::vector<std::vector<double>> cost(count + 1, std::vector<double>(n, kNever));
  std::vector<std::vector<std::size_t>> from(count + 1, std::vector<std::size_t>(n, 0));
  cost[0][0] = 0.0;
  for (std::size_t k = 1; k <= count; ++k) {
    for (std::size_t j = 2 * k; j < n; ++j) {
      for (std::size_t i = 2 * (k - 1); i + 2 <= j; ++i) {
        const double sum = cost[k - 1][i] + sums.squares(i, j);
        if (sum < cost[k][j]) {
          cost[k][j] = sum;
          from[k][j] = i;
        }
      }
    }
  }
  std::vector<std::size_t> cuts(count + 1, n - 1);
  for (std::size_t k = count; k > 0; --k) cuts[k - 1] = from[k][cuts[k]];
  return cuts;
}

/// Returns the point where two lines meet, or `fallback` if it is farther than `within_mm` from it.
Point meeting_point(const LineFit& a, const LineFit& b, Point fallback, double within_mm) noexcept {
  const Vec u = a.to - a.from, v = b.to - b.from;
  const double det = cross(u, v);
  if (!(std::abs(det) > 1e-9 * norm(u) * norm(v))) return fallback;
  const Point met = a.from + (cross(b.from - a.from, v) / det) * u;
  return distance(met, fallback) <= within_mm ? met : fallback;
}

}  // namespace

double rms_to_polygon(std::span<const Point> points, std::span<const Point> corners) {
  if (points.empty() || corners.empty()) return 0.0;
  std::vector<Point> outline(corners.begin(), corners.end());
  outline.push_back(corners.front());
  double sum = 0.0;
  for (const Point p : points) sum += nearest_on_polyline(outline, p).distance_squared;
  return std::sqrt(sum / static_cast<double>(points.size()));
}

std::optional<PolygonFit> fit_polygon(std::span<const Point> path, std::size_t count) {
  const std::size_t n = path.size();
  if (count < 3 || count > kMaxCorners || n < 4 * count) return std::nullopt;
  std::vector<double> turns(n);
  double all_turns = 0.0;
  for (std::size_t i = 0; i < n; ++i) all_turns += turns[i] = turn_at(path, i);
  const auto sharpest = std::max_element(turns.begin(), turns.end()) - turns.begin();
  std::vector<Point> open(path.begin(), path.end());
  std::rotate(open.begin(), open.begin() + sharpest, open.end());
  open.push_back(open.front());
  const std::vector<std::size_t> cuts = best_cuts(open, count);

  std::vector<LineFit> sides;
  for (std::size_t k = 0; k < count; ++k) {
    // Corners are drawn round, so the points next to them are left out if enough others remain.
    const std::size_t skip = cuts[k + 1] - cuts[k] >= 6 ? 1 : 0;
    const std::size_t first = cuts[k] + skip, last = cuts[k + 1] - skip;
    sides.push_back(fit_line(std::span(open).subspan(first, last + 1 - first)));
  }
  PolygonFit fit;
  const double within_mm = 0.2 * diagonal_mm(path);
  std::vector<char> is_near(n, 0);
  for (std::size_t k = 0; k < count; ++k) {
    const LineFit& before = sides[(k + count - 1) % count];
    fit.corners.push_back(meeting_point(before, sides[k], open[cuts[k]], within_mm));
    for (std::size_t i = 0; i <= 2 * kNear; ++i) {
      is_near[(cuts[k] + static_cast<std::size_t>(sharpest) + n - kNear + i) % n] = 1;
    }
  }
  double near_turns = 0.0;
  for (std::size_t i = 0; i < n; ++i) near_turns += is_near[i] ? turns[i] : 0.0;
  fit.corner_share = all_turns > 0.0 ? near_turns / all_turns : 0.0;
  fit.rms_mm = rms_to_polygon(path, fit.corners);
  return fit;
}

std::optional<std::vector<Point>> squared(std::span<const Point> corners, double max_deg) {
  if (corners.size() != 4) return std::nullopt;
  const double max_cos = std::sin(max_deg * std::numbers::pi / 180.0);
  double c = 0.0, s = 0.0;
  Vec sum;
  for (std::size_t i = 0; i < 4; ++i) {
    const Vec side = corners[(i + 1) % 4] - corners[i],
              next = corners[(i + 2) % 4] - corners[(i + 1) % 4];
    if (!(std::abs(dot(side, next)) <= max_cos * norm(side) * norm(next))) return std::nullopt;
    // Four times the angle is the same for all sides of a rectangle.
    const double angle = 4.0 * std::atan2(side.y, side.x);
    c += norm(side) * std::cos(angle);
    s += norm(side) * std::sin(angle);
    sum += corners[i] - corners[0];
  }
  const double angle = 0.25 * std::atan2(s, c);
  const Point middle = corners[0] + sum / 4.0;
  const Vec u{std::cos(angle), std::sin(angle)}, v = perp(u);
  double half_u = 0.0, half_v = 0.0;
  for (const Point p : corners) {
    half_u += 0.25 * std::abs(dot(p - middle, u));
    half_v += 0.25 * std::abs(dot(p - middle, v));
  }
  std::vector<Point> out;
  for (const Point p : corners) {
    const double a = std::copysign(half_u, dot(p - middle, u));
    const double b = std::copysign(half_v, dot(p - middle, v));
    out.push_back(middle + a * u + b * v);
  }
  return out;
}

}  // namespace felt
