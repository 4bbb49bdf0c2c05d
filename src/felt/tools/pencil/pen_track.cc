#include "felt/tools/pencil/pen_track.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace felt {
namespace {

constexpr double kVelocityTauS = 0.015;
/// Maximum time step. A longer gap between samples counts as kMaxStepS.
constexpr double kMaxStepS = 0.1;
/// Distance between the points at which turns are measured.
constexpr double kTurnStepMm = 0.5;
/// Assumed maximum turn of a path before it reaches a target.
constexpr double kMaxBend = 45.0 * std::numbers::pi / 180.0;

double turn_between(Vec a, Vec b) noexcept {
  return std::atan2(cross(a, b), dot(a, b));
}

Vec turned(Vec v, double angle) noexcept {
  const double c = std::cos(angle), s = std::sin(angle);
  return {c * v.x - s * v.y, s * v.x + c * v.y};
}

double distance_to_chord(Point q, Point a, Point b) noexcept {
  const Vec ab = b - a;
  const double squared = norm_squared(ab);
  const double t = squared > 0.0 ? std::clamp(dot(q - a, ab) / squared, 0.0, 1.0) : 0.0;
  return distance(q, lerp(a, b, t));
}

}  // namespace

void PenTrack::begin(Point start, std::int64_t time_ns) noexcept {
  *this = {};
  start_ = pen_ = turn_from_ = start;
  time_ns_ = time_ns;
  nodes_[0] = start;
  count_ = 1;
}

void PenTrack::push(Point pen, std::int64_t time_ns) noexcept {
  // Computed in double, because the difference of two invalid times may overflow 64 bits.
  const double dt_s =
      std::min(1e-9 * (static_cast<double>(time_ns) - static_cast<double>(time_ns_)), kMaxStepS);
  if (dt_s > 0.0) {
    velocity_ += (1.0 - std::exp(-dt_s / kVelocityTauS)) * ((pen - pen_) / dt_s - velocity_);
    time_ns_ = time_ns;
  }
  pen_ = pen;
  if (open_step_mm() >= kNodeMm) add_node(pen);
}

void PenTrack::add_node(Point pen) noexcept {
  const Point last = node(0);
  length_mm_ += distance(last, pen);
  extent_mm_ = std::max(extent_mm_, distance(start_, pen));
  area_mm2_ += 0.5 * cross(last - start_, pen - start_);
  latest_ = (latest_ + 1) % kNodes;
  nodes_[latest_] = pen;
  count_ = std::min(count_ + 1, kNodes);
  if (distance(turn_from_, pen) >= kTurnStepMm) {
    const Vec step = pen - turn_from_;
    if (turn_step_) turns_ += turn_between(*turn_step_, step) / (2.0 * std::numbers::pi);
    turn_step_ = step;
    turn_from_ = pen;
  }
  if (!first_from_ && length_mm_ >= kFirstFromMm) first_from_ = pen;
  if (!first_direction_ && length_mm_ >= kFirstToMm) {
    const Vec way = pen - (length_mm_ > 4.0 * kFirstToMm ? start_ : *first_from_);
    if (norm(way) > 0.5 * kNodeMm) first_direction_ = normalized(way);
  }
}

Point PenTrack::node(std::size_t i) const noexcept {
  return nodes_[(latest_ + kNodes - i) % kNodes];
}

std::optional<Point> PenTrack::back(double distance_mm) const noexcept {
  Point from = pen_;
  for (std::size_t i = 0; i < count_; ++i) {
    const double step = distance(from, node(i));
    if (step >= distance_mm) return lerp(from, node(i), distance_mm / std::max(step, 1e-12));
    distance_mm -= step;
    from = node(i);
  }
  return std::nullopt;
}

std::optional<Vec> PenTrack::heading(double ahead_mm) const noexcept {
  const auto a = back(kChordMm), b = back(2.0 * kChordMm);
  if (!a || norm(pen_ - *a) < 0.5 * kNodeMm) return std::nullopt;
  const Vec last = pen_ - *a;
  if (!b) return normalized(last);
  // Each chord gives the direction at its middle.
  const double bend = turn_between(*a - *b, last) * (0.5 + 0.5 * ahead_mm / kChordMm);
  return turned(normalized(last), std::clamp(bend, -kMaxBend, kMaxBend));
}

double PenTrack::passed_within_mm(Point target) const noexcept {
  constexpr double kRecentMm = 3.0;
  double nearest = distance(pen_, target), left = kRecentMm;
  Point from = pen_;
  for (std::size_t i = 0; i < count_ && left > 0.0; ++i) {
    nearest = std::min(nearest, distance_to_chord(target, from, node(i)));
    left -= distance(from, node(i));
    from = node(i);
  }
  return nearest;
}

}  // namespace felt
