#include "felt/io/svg/svg_path_builder.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace felt {
namespace {

constexpr double kPi = std::numbers::pi;

/// An elliptical arc in centre parameterisation.
struct CenterArc {
  Point center;
  Vec axis_x, axis_y;  ///< images of the unit circle's axes
  double begin_rad = 0.0;
  double sweep_rad = 0.0;

  [[nodiscard]] Point at(double angle) const noexcept {
    return center + std::cos(angle) * axis_x + std::sin(angle) * axis_y;
  }
  [[nodiscard]] Vec slope(double angle) const noexcept {
    return std::cos(angle) * axis_y - std::sin(angle) * axis_x;
  }
};

/// Computes an arc as in SVG 1.1, F.6.5 and F.6.6. Requires radii above 0 and different ends.
CenterArc center_arc(Point from, Point to, Vec radii, double turn_rad, bool large, bool sweep) {
  const double cosine = std::cos(turn_rad), sine = std::sin(turn_rad);
  const Vec half = 0.5 * (from - to);
  const double x = (cosine * half.x + sine * half.y) / radii.x;
  const double y = (cosine * half.y - sine * half.x) / radii.y;
  const double reach = x * x + y * y;
  const double grow = std::sqrt(std::max(1.0, reach));
  // In units of the ellipse's radii, the ends are (x, y) and (-x, -y), and the ellipse is a circle
  // of radius `grow`.
  const double away = std::sqrt(std::max(0.0, grow * grow / reach - 1.0));
  const double side = large == sweep ? -away : away;
  const double cx = side * y, cy = -side * x;
  CenterArc arc;
  arc.axis_x = grow * radii.x * Vec{cosine, sine};
  arc.axis_y = grow * radii.y * Vec{-sine, cosine};
  arc.center = lerp(from, to, 0.5) + (cx / grow) * arc.axis_x + (cy / grow) * arc.axis_y;
  arc.begin_rad = std::atan2(y - cy, x - cx);
  const double end_rad = std::atan2(-y - cy, -x - cx);
  arc.sweep_rad = end_rad - arc.begin_rad;
  if (sweep && arc.sweep_rad < 0.0) arc.sweep_rad += 2.0 * kPi;
  if (!sweep && arc.sweep_rad > 0.0) arc.sweep_rad -= 2.0 * kPi;
  return arc;
}

/// Returns true if the current point is the start of the contour. Allows for rounding, because
/// relative commands in decimals do not return to the start exactly.
bool is_back(Point here, Point begin) noexcept {
  const double size = std::max({1.0, std::fabs(begin.x), std::fabs(begin.y)});
  return distance(here, begin) <= 1e-9 * size;
}

}  // namespace

void SvgPathBuilder::move(Point p) {
  here_ = begin_ = p;
  open_ = false;
  moved_ = true;
}

bool SvgPathBuilder::begin_segment() {
  if (room_ == 0) {
    full_ = true;
    return false;
  }
  --room_;
  if (!open_) {
    contours_.push_back({{here_}, false});
    begin_ = here_;
    open_ = true;
    moved_ = false;
  }
  return true;
}

void SvgPathBuilder::line(Point p) {
  // In a line without length, all points must be equal; computed thirds could differ by rounding.
  const Cubic c = p == here_ ? Cubic{{p, p, p, p}} : straight(here_, p);
  cubic(c.p[1], c.p[2], p);
}

void SvgPathBuilder::cubic(Point a, Point b, Point p) {
  if (!begin_segment()) return;
  contours_.back().points.insert(contours_.back().points.end(), {a, b, p});
  here_ = p;
}

void SvgPathBuilder::quadratic(Point control, Point p) {
  cubic(lerp(here_, control, 2.0 / 3.0), lerp(p, control, 2.0 / 3.0), p);
}

void SvgPathBuilder::arc(double rx, double ry, double turn_deg, bool large, bool sweep, Point p) {
  const Vec radii{std::fabs(rx), std::fabs(ry)};
  if (p == here_) return;
  if (radii.x == 0.0 || radii.y == 0.0) return line(p);
  const CenterArc arc = center_arc(here_, p, radii, turn_deg * (kPi / 180.0), large, sweep);
  if (!std::isfinite(arc.sweep_rad) || !is_finite(arc.center)) return line(p);
  // Slightly more than a quarter is still one piece, because rounding enlarges half circles.
  const double quarters = std::ceil(std::fabs(arc.sweep_rad) / (0.5 * kPi) - 1e-9);
  const int count = std::clamp(static_cast<int>(quarters), 1, 4);
  const double step = arc.sweep_rad / count, handle = 4.0 / 3.0 * std::tan(0.25 * step);
  for (int i = 0; i < count; ++i) {
    const double a = arc.begin_rad + i * step, b = arc.begin_rad + (i + 1) * step;
    const Point end = i + 1 == count ? p : arc.at(b);
    cubic((i == 0 ? here_ : arc.at(a)) + handle * arc.slope(a), end - handle * arc.slope(b), end);
  }
}

void SvgPathBuilder::close() {
  if (!open_ && !moved_) return;  // already closed
  // A move that is closed immediately becomes a dot if the line has caps.
  if (open_ && is_back(here_, begin_)) {
    contours_.back().points.back() = begin_;
  } else {
    line(begin_);
  }
  if (open_) contours_.back().closed = true;
  here_ = begin_;
  open_ = false;
}

std::vector<SvgContour> SvgPathBuilder::take() {
  open_ = false;
  return std::exchange(contours_, {});
}

}  // namespace felt
