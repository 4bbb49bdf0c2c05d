#include "felt/stroke/corner_detector.h"

#include <algorithm>
#include <numbers>

namespace felt {
namespace {

constexpr std::size_t kArmSamples = 2;
constexpr double kCornerRad = CornerDetector::kCornerDeg * std::numbers::pi / 180.0;

double distance_to_segment(Point p, Point a, Point b) noexcept {
  const Vec along = b - a;
  const double squared = norm_squared(along);
  const double t = squared > 0.0 ? std::clamp(dot(p - a, along) / squared, 0.0, 1.0) : 0.0;
  return distance(p, a + t * along);
}

// Length of the arms at sample k: the documented one, or two samples.
double arm_at(const SampleWindow& w, std::size_t k) noexcept {
  const double here = w.path_mm(k);
  return std::max({CornerDetector::kCornerArm * w.tolerance_mm(), here - w.path_mm(k - kArmSamples),
                   w.path_mm(k + kArmSamples) - here});
}

// Largest distance of the samples strictly inside the arm from its chord.
double bend(const SampleWindow& w, std::size_t k, double arm, Point end, int step) noexcept {
  double largest = 0.0;
  for (std::size_t i = k;;) {
    if (step < 0 ? i == 0 : i + 1 == w.size()) break;
    i = step < 0 ? i - 1 : i + 1;
    if (std::fabs(w.path_mm(i) - w.path_mm(k)) >= arm) break;
    largest = std::max(largest, distance_to_segment(w.point(i), end, w.point(k)));
  }
  return largest;
}

// Turn of the ink at sample k in radians if it counts as a corner, else 0.
double corner_turn(const SampleWindow& w, std::size_t k) noexcept {
  const double arm = arm_at(w, k);
  const double here = w.path_mm(k);
  const Point p = w.point(k);
  const Point a = w.point_at_path(here - arm, k - 1);
  const Point b = w.point_at_path(here + arm, k);
  // cos(turn) > cos(limit) without an arc tangent: nearly all samples leave here.
  const Vec in = p - a, out = b - p;
  static const double cos_limit = std::cos(kCornerRad);
  if (dot(in, out) > cos_limit * norm(in) * norm(out)) return 0.0;
  const double faked = 2.0 * (bend(w, k, arm, a, -1) + bend(w, k, arm, b, +1)) / arm;
  const double turn = angle_between(in, out) - faked;
  if (turn < kCornerRad) return 0.0;
  const Vec near_in = p - w.point_at_path(here - 0.5 * arm, k - 1);
  const Vec near_out = w.point_at_path(here + 0.5 * arm, k) - p;
  const double near_turn = angle_between(near_in, near_out);
  return near_turn < CornerDetector::kCornerPersistence * turn ? 0.0 : turn;
}

// True when no other turn within one arm is larger; of equal ones the first counts.
bool is_largest(const SampleWindow& w, std::size_t k) noexcept {
  const double arm = CornerDetector::kCornerArm * w.tolerance_mm();
  for (std::size_t i = k; i-- > 0 && w.path_mm(i) > w.path_mm(k) - arm;) {
    if (w.turn(i) >= w.turn(k)) return false;
  }
  for (std::size_t i = k + 1; i < w.size() && w.path_mm(i) < w.path_mm(k) + arm; ++i) {
    if (w.turn(i) > w.turn(k)) return false;
  }
  return true;
}

}  // namespace

void CornerDetector::clear() noexcept {
  measured_ = 0;
  decided_ = 0;
}

void CornerDetector::shift(std::size_t count) noexcept {
  measured_ -= count;
  decided_ -= count;
}

void CornerDetector::update(SampleWindow& w) noexcept {
  const double margin = kCornerMargin * w.tolerance_mm();
  const double arm = kCornerArm * w.tolerance_mm();
  if (w.size() == 0) return;
  const double newest = w.path_mm(w.size() - 1);
  while (measured_ + kArmSamples < w.size()) {
    const double here = w.path_mm(measured_);
    const bool at_start = measured_ < kArmSamples || here < margin;
    if (!at_start) {
      if (newest < here + std::max(margin, arm_at(w, measured_))) break;
      if (here >= arm_at(w, measured_)) w.set_turn(measured_, corner_turn(w, measured_));
    }
    ++measured_;
  }
  // A turn is the largest of its neighbourhood once all of the neighbourhood is measured.
  while (decided_ < measured_) {
    if (w.turn(decided_) > 0.0) {
      if (w.path_mm(measured_) < w.path_mm(decided_) + arm) break;
      if (is_largest(w, decided_)) w.set_corner(decided_);
    }
    ++decided_;
  }
}

void CornerDetector::finish(SampleWindow& w) noexcept {
  update(w);
  for (; decided_ < w.size(); ++decided_) {
    if (w.turn(decided_) > 0.0 && is_largest(w, decided_)) w.set_corner(decided_);
  }
  measured_ = w.size();
}

}  // namespace felt
