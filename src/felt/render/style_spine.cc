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
constexpr double kNoMark = -1.0;

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
  dabs_.clear();
  is_corner_.clear();
  marks_.clear();
  points_.clear();
  corners_.clear();
  add_dabs(row, max_step);
  if (dabs_.size() < 2) return;
  measure();
  add_points(row.is_mirrored ? -1.0 : 1.0, !row.marks.empty());
}

/// Copies the dabs without those that are in one place, and divides long or tapered chords.
void Spine::add_dabs(const StyledRow& row, double max_step) {
  double wanted = 0.0;
  for (std::size_t i = 0; i + 1 < row.dabs.size(); ++i) {
    wanted += steps_between(row.dabs[i], row.dabs[i + 1], max_step);
  }
  const double share = std::min(1.0, static_cast<double>(kMaxPoints) / std::max(1.0, wanted));
  std::size_t corner = 0, mark = 0;
  for (std::size_t i = 0; i < row.dabs.size(); ++i) {
    const Dab& dab = row.dabs[i];
    const bool is_corner = corner < row.corners.size() && row.corners[corner] == i;
    if (is_corner) ++corner;
    const bool is_mark = mark < row.marks.size() && row.marks[mark].dab == i;
    const double along = is_mark ? row.marks[mark++].along : kNoMark;
    if (!dabs_.empty()) {
      const Dab from = dabs_.back();
      if (!(distance(from.center, dab.center) > 1e-9 * dab.radius_mm)) {
        is_corner_.back() = is_corner_.back() || is_corner;
        if (is_mark) marks_.back() = along;
        continue;
      }
      const double steps = std::max(1.0, std::floor(share * steps_between(from, dab, max_step)));
      for (double k = 1.0; k < steps; ++k) {
        const double t = k / steps;
        dabs_.push_back({lerp(from.center, dab.center, t),
                         std::lerp(from.radius_mm, dab.radius_mm, t),
                         std::lerp(from.tone, dab.tone, t)});
        is_corner_.push_back(false);
        marks_.push_back(kNoMark);
      }
    }
    dabs_.push_back(dab);
    is_corner_.push_back(is_corner);
    marks_.push_back(along);
  }
}

/// Computes the positions of the dabs: those between two marks are scaled to fit.
void Spine::measure() {
  alongs_.assign(dabs_.size(), 0.0);
  std::size_t from = 0;  // the last mark
  double begin = 0.0, sum = 0.0;
  for (std::size_t i = 1; i < dabs_.size(); ++i) {
    sum += length_in_widths(dabs_[i - 1], dabs_[i]);
    alongs_[i] = begin + sum;
    if (marks_[i] == kNoMark) continue;
    const double scale = sum > 0.0 ? std::max(0.0, marks_[i] - begin) / sum : 0.0;
    for (std::size_t k = from + 1; k <= i; ++k) alongs_[k] = begin + scale * (alongs_[k] - begin);
    from = i;
    begin = alongs_[i];
    sum = 0.0;
  }
}

void Spine::add_points(double side, bool has_marks) {
  const std::size_t last = dabs_.size() - 1;
  const auto normal_after = [&](std::size_t i) {
    return side * normalized(perp(dabs_[i + 1].center - dabs_[i].center));
  };
  double length = 0.0;
  for (std::size_t i = 0; i <= last; ++i) {
    const Dab& dab = dabs_[i];
    if (i > 0) length += distance(dabs_[i - 1].center, dab.center);
    const double along = alongs_[i];
    const bool has_before = i > 0 || closed_, has_after = i < last || closed_;
    const Vec before = has_before ? normal_after(i > 0 ? i - 1 : last - 1) : normal_after(i);
    const Vec after = has_after ? normal_after(i < last ? i : 0) : before;
    SpinePoint p{dab.center, dab.radius_mm, dab.tone, before, along, length};
    if (dot(before, after) > kSharp) {
      p.normal = normalized(before + after);
      points_.push_back(p);
    } else {
      const double turn = std::atan2(cross(before, after), dot(before, after));
      const bool is_seam = i == 0 || i == last;  // of a closed line
      const Vec half = std::cos(0.5 * turn) * before + std::sin(0.5 * turn) * perp(before);
      add_turn(p, i == 0 ? half : before, is_seam ? 0.5 * turn : turn);
    }
    const bool is_end = i == last || (i == 0 && !closed_);
    if (!is_corner_[i] || is_end) continue;
    if (has_marks || dot(before, after) < kBlunt) corners_.push_back(along);
  }
}

/// Adds an odd number of points at the position of p, whose normals turn from `normal`.
void Spine::add_turn(SpinePoint p, Vec normal, double turn) {
  const double steps = 2.0 * std::ceil(0.5 * std::fabs(turn) / kMaxTurn);
  for (double k = 0.0; k <= steps; ++k) {
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
