#include "felt/render/style_spine.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "felt/render/styled_outline.h"

namespace felt {
namespace {

/// Between two points, the radius changes by at most this factor, so that positions are nearly
/// linear in between.
constexpr double kMaxRatio = 1.15;

/// Normals of adjacent chords with a smaller scalar product (60 degrees) are not averaged.
constexpr double kSharp = 0.5;
/// Largest turn between two points at the same position.
constexpr double kMaxTurn = std::numbers::pi / 12.0;

double steps_between(const Dab& a, const Dab& b, double max_step) noexcept {
  const double ratio = std::fabs(std::log(b.radius_mm / a.radius_mm)) / std::log(kMaxRatio);
  return std::max(1.0, std::ceil(std::max(ratio, length_in_widths(a, b) / max_step)));
}

SpinePoint between(const SpinePoint& a, const SpinePoint& b, double t) noexcept {
  const Vec normal = normalized((1.0 - t) * a.normal + t * b.normal);
  return {lerp(a.center, b.center, t),    std::lerp(a.radius, b.radius, t),
          std::lerp(a.tone, b.tone, t),   normal == Vec{} ? a.normal : normal,
          std::lerp(a.along, b.along, t), std::lerp(a.length, b.length, t)};
}

}  // namespace

double length_in_widths(const Dab& a, const Dab& b) noexcept {
  const double change = b.radius_mm - a.radius_mm, sum = a.radius_mm + b.radius_mm;
  const double length = distance(a.center, b.center);
  if (std::fabs(change) <= 1e-3 * sum) return length / sum;
  return length * std::log(b.radius_mm / a.radius_mm) / (2.0 * change);
}

void Spine::build(const StyledRow& row, double max_step) {
  closed_ = row.closed;
  knots_.clear();
  points_.clear();
  corners_.clear();
  add_knots(row, max_step);
  if (knots_.size() < 2) return;
  measure();
  add_points(row.is_mirrored ? -1.0 : 1.0, !row.marks.empty());
}

/// Copies the dabs, and divides long or tapered chords.
void Spine::add_knots(const StyledRow& row, double max_step) {
  double wanted = 0.0;
  for (std::size_t i = 0; i + 1 < row.dabs.size(); ++i) {
    wanted += steps_between(row.dabs[i], row.dabs[i + 1], max_step);
  }
  const double share = std::min(1.0, static_cast<double>(kMaxPoints) / std::max(1.0, wanted));
  auto corner = row.corners.begin();
  auto mark = row.marks.begin();
  for (std::size_t i = 0; i < row.dabs.size(); ++i) {
    Knot knot{row.dabs[i]};
    knot.is_corner = corner != row.corners.end() && *corner == i;
    if (knot.is_corner) ++corner;
    if (mark != row.marks.end() && mark->dab == i) knot.mark = (mark++)->along;
    const double steps =
        knots_.empty() ? 1.0 : share * steps_between(knots_.back().dab, knot.dab, max_step);
    add_knot(knot, static_cast<int>(std::min(steps, static_cast<double>(kMaxPoints))));
  }
}

/// Adds a knot and those between it and the one before, at equal distances. Joins it with the one
/// before if both are in one place.
void Spine::add_knot(const Knot& knot, int steps) {
  if (knots_.empty()) return knots_.push_back(knot);
  const Dab from = knots_.back().dab;
  if (!(distance(from.center, knot.dab.center) > 1e-9 * knot.dab.radius_mm)) {
    Knot& last = knots_.back();
    last.is_corner = last.is_corner || knot.is_corner;
    if (knot.mark >= 0.0) last.mark = knot.mark;
    return;
  }
  for (int k = 1; k < steps; ++k) {
    const double t = static_cast<double>(k) / steps;
    knots_.push_back(
        {{lerp(from.center, knot.dab.center, t), std::lerp(from.radius_mm, knot.dab.radius_mm, t),
          std::lerp(from.tone, knot.dab.tone, t)}});
  }
  knots_.push_back(knot);
}

/// Computes the positions of the knots: those between two marks are scaled to fit.
void Spine::measure() {
  std::size_t from = 0;  // the last mark
  double begin = 0.0, sum = 0.0;
  for (std::size_t i = 1; i < knots_.size(); ++i) {
    sum += length_in_widths(knots_[i - 1].dab, knots_[i].dab);
    knots_[i].along = begin + sum;
    if (knots_[i].mark < 0.0) continue;
    const double scale = sum > 0.0 ? std::max(0.0, knots_[i].mark - begin) / sum : 0.0;
    for (std::size_t k = from + 1; k <= i; ++k) {
      knots_[k].along = begin + scale * (knots_[k].along - begin);
    }
    from = i;
    begin = knots_[i].along;
    sum = 0.0;
  }
}

/// Returns the normals before and after a knot, which are equal at an end.
std::pair<Vec, Vec> Spine::normals(std::size_t knot, double side) const noexcept {
  const std::size_t last = knots_.size() - 1;
  const auto normal_after = [&](std::size_t i) {
    return side * normalized(perp(knots_[i + 1].dab.center - knots_[i].dab.center));
  };
  if (knot > 0 && knot < last) return {normal_after(knot - 1), normal_after(knot)};
  const Vec before = normal_after(last - 1), after = normal_after(0);
  if (closed_) return {before, after};
  return knot == 0 ? std::pair{after, after} : std::pair{before, before};
}

void Spine::add_points(double side, bool has_marks) {
  const std::size_t last = knots_.size() - 1;
  double length = 0.0;
  for (std::size_t i = 0; i <= last; ++i) {
    const Dab& dab = knots_[i].dab;
    if (i > 0) length += distance(knots_[i - 1].dab.center, dab.center);
    const auto [before, after] = normals(i, side);
    add_bend(i, {dab.center, dab.radius_mm, dab.tone, before, knots_[i].along, length}, after);
    const bool is_end = i == last || (i == 0 && !closed_);
    if (is_end || !knots_[i].is_corner) continue;
    if (has_marks || dot(before, after) < kBlunt) corners_.push_back(knots_[i].along);
  }
}

/// Adds a point of the knot `knot`, or several if the bend there is sharp. p.normal is the normal
/// before it.
void Spine::add_bend(std::size_t knot, SpinePoint p, Vec after) {
  const Vec before = p.normal;
  if (dot(before, after) > kSharp) {
    p.normal = normalized(before + after);
    return points_.push_back(p);
  }
  const double turn = std::atan2(cross(before, after), dot(before, after));
  const bool is_seam = knot == 0 || knot + 1 == knots_.size();  // of a closed line
  const Vec half = std::cos(0.5 * turn) * before + std::sin(0.5 * turn) * perp(before);
  add_turn(p, knot == 0 ? half : before, is_seam ? 0.5 * turn : turn);
}

/// Adds an odd number of points at the position of p, whose normals turn from `normal`.
void Spine::add_turn(SpinePoint p, Vec normal, double turn) {
  const int steps = 2 * static_cast<int>(std::ceil(0.5 * std::fabs(turn) / kMaxTurn));
  for (int k = 0; k <= steps; ++k) {
    const double angle = turn * k / steps;
    p.normal = std::cos(angle) * normal + std::sin(angle) * perp(normal);
    points_.push_back(p);
  }
}

std::size_t Spine::next(double along) const noexcept {
  const auto found = std::upper_bound(points_.begin(), points_.end(), along,
                                      [](double x, const SpinePoint& p) { return x < p.along; });
  return static_cast<std::size_t>(found - points_.begin());
}

SpinePoint Spine::at(double along) const noexcept {
  const std::size_t i = next(along);
  if (i == 0) return points_.front();
  if (i == points_.size()) return points_.back();
  const SpinePoint &a = points_[i - 1], &b = points_[i];
  return between(a, b, (along - a.along) / (b.along - a.along));
}

std::size_t Spine::first(double along) const noexcept {
  const auto found = std::lower_bound(points_.begin(), points_.end(), along,
                                      [](const SpinePoint& p, double x) { return p.along < x; });
  return static_cast<std::size_t>(found - points_.begin());
}

std::optional<std::size_t> Spine::joint(double along) const noexcept {
  const std::size_t from = first(along), to = next(along);
  if (from == to) return std::nullopt;
  if (from == 0) return 0;
  return to == points_.size() ? to - 1 : (from + to - 1) / 2;
}

}  // namespace felt
