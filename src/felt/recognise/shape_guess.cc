#include "felt/recognise/shape_guess.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "felt/geometry/polyline.h"
#include "felt/recognise/even_path.h"
#include "felt/recognise/polygon_fit.h"
#include "felt/recognise/round_fit.h"

namespace felt {
namespace {

using Limits = ShapeLimits;

constexpr std::size_t kShapePoints = 72;
constexpr double kAllAround = 2.0 * std::numbers::pi;
/// A shape is offered besides the best one if its misfit is at most this much larger.
constexpr double kNearlyEqual = 0.35;
/// The same for a shape with fewer freedoms besides a polygon with any corners, which also fits the
/// unsteadiness of the hand.
constexpr double kBesidesPolygon = 0.65;
/// A shape with more freedom must fit better by this much to come first.
constexpr double kSimpler = 0.15;
/// With a smaller misfit, what is left is the unsteadiness of the hand, and no more corners are
/// tried.
constexpr double kWellFitted = 0.25;
/// Ratio of the radii at which a circle and an ellipse are equally likely.
constexpr double kMiddleRatio = 0.82;

/// The path of a stroke, prepared for all fits.
struct PreparedPath {
  std::span<const Point> drawn;
  std::vector<Point> points;  // at equal distances
  double length_mm = 0.0, diagonal_mm = 0.0, gap_mm = 0.0;

  [[nodiscard]] bool is_closed() const noexcept { return gap_mm <= Limits::kMaxGap * length_mm; }
};

/// Returns the angle that a path sweeps around a point.
double sweep_about(std::span<const Point> path, Point center) noexcept {
  double sweep = 0.0;
  for (std::size_t i = 1; i < path.size(); ++i) {
    const Vec a = path[i - 1] - center, b = path[i] - center;
    sweep += std::atan2(cross(a, b), dot(a, b));
  }
  return sweep;
}

/// How far a path moves in a direction, and against it.
struct Motion {
  double forth_mm = 0.0, back_mm = 0.0;
};

/// Returns the motion of a path between its turning points. A motion shorter than `least_mm` makes
/// no turning point. Leaves out points that are not in range.
Motion motion_along(std::span<const Point> path, Point origin, Vec direction,
                    double least_mm) noexcept {
  Motion motion;
  double sign = 1.0, turned = 0.0, farthest = 0.0;  // all in the present direction
  const auto add = [&] { (sign > 0.0 ? motion.forth_mm : motion.back_mm) += farthest - turned; };
  for (const Point p : path) {
    if (!is_in_range(p)) continue;
    const double at = sign * dot(p - origin, direction);
    farthest = std::max(farthest, at);
    if (farthest - at < least_mm) continue;
    add();
    sign = -sign;
    turned = -farthest;
    farthest = -at;
  }
  add();
  return motion;
}

void add_line(const PreparedPath& path, std::vector<ShapeGuess>& out) {
  const LineFit fit = fit_line(path.points);
  const double length = distance(fit.from, fit.to);
  // A quick hand goes beyond the end and comes back, so a short return is accepted. A path that
  // runs to and fro, or from side to side as a wave, a zigzag or a coil does, is not a line.
  const Vec along = normalized(fit.to - fit.from), across{-along.y, along.x};
  const double least = std::max(Limits::kMinMotionMm, Limits::kMinMotion * length);
  const Point start = path.points.front();
  if (motion_along(path.drawn, start, along, least).back_mm > Limits::kMaxReturn * length) return;
  const Motion sideways = motion_along(path.drawn, start, across, least);
  if (sideways.forth_mm + sideways.back_mm > Limits::kMaxSideways * length) return;
  out.push_back({.form = ShapeForm::kLine,
                 .misfit = fit.rms_mm / (Limits::kLineRms * length),
                 .corners = {fit.from, fit.to}});
}

void add_arc(const PreparedPath& path, std::vector<ShapeGuess>& out) {
  const CircleFit fit = fit_circle(path.points);
  if (!(fit.radius_mm > 0.0) || fit.radius_mm > 20.0 * path.diagonal_mm) return;
  const double sweep = sweep_about(path.points, fit.center);
  if (std::abs(sweep) > 0.92 * kAllAround) return;
  const double chord = 2.0 * fit.radius_mm * std::sin(std::min(0.5 * std::abs(sweep), 1.5));
  const double bend = fit.radius_mm * (1.0 - std::cos(0.5 * sweep));
  if (bend < Limits::kMinBend * chord) return;
  const Vec start = path.points.front() - fit.center;
  out.push_back({.form = ShapeForm::kArc,
                 .misfit = kSimpler + fit.rms_mm / (Limits::kArcRms * path.length_mm),
                 .center = fit.center,
                 .long_mm = fit.radius_mm,
                 .short_mm = fit.radius_mm,
                 .from = std::atan2(start.y, start.x),
                 .sweep = sweep});
}

void add_round(const PreparedPath& path, std::vector<ShapeGuess>& out) {
  const EllipseFit ellipse = fit_ellipse(path.points);
  const CircleFit circle = fit_circle(path.points);
  if (!(ellipse.short_mm > 0.0) || !(circle.radius_mm > 0.0)) return;
  const double sweep = sweep_about(path.points, ellipse.center);
  if (std::abs(sweep) < 0.78 * kAllAround || std::abs(sweep) > 1.3 * kAllAround) return;
  const double ratio = ellipse.short_mm / ellipse.long_mm;
  if (!(ratio > 0.08) || ellipse.long_mm > path.diagonal_mm) return;
  const double whole = std::copysign(kAllAround, sweep);
  const auto add = [&](ShapeForm form, Point center, double a, double b, double angle,
                       double misfit) {
    const Vec start = path.points.front() - center;
    out.push_back({.form = form,
                   .misfit = misfit,
                   .center = center,
                   .long_mm = a,
                   .short_mm = b,
                   .angle = angle,
                   .from = std::atan2(start.y, start.x) - angle,
                   .sweep = whole});
  };
  const double misfit = ellipse.rms_mm / (Limits::kRoundRms * (ellipse.long_mm + ellipse.short_mm));
  // A hand draws a circle with radii that differ by a tenth or two, so the ellipse always fits
  // better. The ratio of the radii decides which one comes first.
  const double rounder = kSimpler * (ratio - kMiddleRatio) / 0.1;
  if (ratio >= Limits::kCircleFrom) {
    add(ShapeForm::kCircle, circle.center, circle.radius_mm, circle.radius_mm, 0.0,
        misfit + std::max(0.0, -rounder));
  }
  if (ratio < Limits::kCircleOnlyFrom) {
    add(ShapeForm::kEllipse, ellipse.center, ellipse.long_mm, ellipse.short_mm, ellipse.angle,
        misfit + std::max(0.0, rounder));
  }
}

void add_polygons(const PreparedPath& path, std::vector<ShapeGuess>& out) {
  // The link from the end to the start belongs to the path.
  std::vector<Point> closed = path.points;
  closed.push_back(closed.front());
  std::vector<Point> around(kShapePoints + 1);
  resample(closed, around);
  around.pop_back();
  double best = 0.0;
  for (std::size_t count = 3; count <= kMaxCorners; ++count) {
    const auto fit = fit_polygon(around, count);
    if (!fit || fit->corner_share < Limits::kMinCornerShare) continue;
    const double unit = Limits::kPolygonRms * path.diagonal_mm;
    ShapeGuess guess{.form = count == 3 ? ShapeForm::kTriangle : ShapeForm::kPolygon,
                     .misfit = fit->rms_mm / unit,
                     .corners = fit->corners};
    // More corners always fit better; they count only if they fit much better.
    if (best > 0.0 && guess.misfit > 0.6 * best) continue;
    if (count == 4) {
      if (auto corners = squared(fit->corners, Limits::kMaxSquareDeg)) {
        guess.form = ShapeForm::kRectangle;
        guess.misfit = rms_to_polygon(around, *corners) / unit;
        guess.corners = *std::move(corners);
      }
    }
    if (guess.misfit > 1.0) continue;
    best = guess.misfit;
    out.push_back(std::move(guess));
    if (best < kWellFitted) break;
  }
}

/// Keeps the shapes within their limits that are nearly as good as the best one.
void keep_best(std::vector<ShapeGuess>& guesses) {
  std::erase_if(guesses, [](const ShapeGuess& g) { return !(g.misfit <= 1.0); });
  std::stable_sort(guesses.begin(), guesses.end(),
                   [](const ShapeGuess& a, const ShapeGuess& b) { return a.misfit < b.misfit; });
  std::vector<ShapeGuess> kept;
  for (ShapeGuess& guess : guesses) {
    const bool is_besides_polygon = !kept.empty() && kept.front().form == ShapeForm::kPolygon;
    const double margin = is_besides_polygon ? kBesidesPolygon : kNearlyEqual;
    const bool is_near = kept.empty() || guess.misfit <= kept.front().misfit + margin;
    const bool is_new = std::none_of(kept.begin(), kept.end(), [&](const ShapeGuess& other) {
      return other.form == guess.form;
    });
    if (is_near && is_new && kept.size() < kMaxGuesses) kept.push_back(std::move(guess));
  }
  guesses = std::move(kept);
}

}  // namespace

std::vector<ShapeGuess> guess_shapes(std::span<const Point> drawn) {
  PreparedPath path;
  path.drawn = drawn;
  path.points = even_path(drawn, kShapePoints);
  std::vector<ShapeGuess> guesses;
  if (path.points.empty()) return guesses;
  path.length_mm = polyline_length(path.points);
  path.diagonal_mm = diagonal_mm(path.points);
  path.gap_mm = distance(path.points.front(), path.points.back());
  if (!(path.diagonal_mm >= Limits::kMinSizeMm)) return guesses;
  add_line(path, guesses);
  add_arc(path, guesses);
  if (path.is_closed()) {
    add_round(path, guesses);
    add_polygons(path, guesses);
  }
  keep_best(guesses);
  return guesses;
}

}  // namespace felt
