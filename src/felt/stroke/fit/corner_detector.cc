#include "felt/stroke/fit/corner_detector.h"

#include <algorithm>
#include <numbers>

namespace felt {
namespace {

constexpr std::size_t kArmSamples = 2;
// Samples measured in one update: enough to catch up after samples that had to wait for later ones,
// few enough to bound the work of one sample.
constexpr std::size_t kMeasuresPerUpdate = 4;
constexpr std::size_t kOpen = static_cast<std::size_t>(-1);
constexpr double kCornerRad = CornerDetector::kCornerDeg * std::numbers::pi / 180.0;

// The direction from sample k: towards earlier samples (kBack) or later ones (kOn).
enum class Way { kBack, kOn };

std::size_t sample_at(std::size_t k, Way way, std::size_t steps) noexcept {
  return way == Way::kBack ? k - steps : k + steps;
}

double distance_to_segment(Point p, Point a, Point b) noexcept {
  const Vec along = b - a;
  const double squared = norm_squared(along);
  const double t = squared > 0.0 ? std::clamp(dot(p - a, along) / squared, 0.0, 1.0) : 0.0;
  return distance(p, a + t * along);
}

// Returns the number of steps from sample k to the first sample that is `reach` away from it.
// Returns 0 if the path to that sample is a detour, and kOpen if the samples end before this is
// known.
std::size_t steps_to(const KeptSamples& w, std::size_t k, Way way, double reach) noexcept {
  const Point p = w.point(k);
  const double squared = reach * reach, longest = CornerDetector::kCornerDetour * reach;
  const std::size_t available = way == Way::kBack ? k : w.size() - 1 - k;
  for (std::size_t steps = 1; steps <= available; ++steps) {
    const std::size_t i = sample_at(k, way, steps);
    if (distance_squared(p, w.point(i)) >= squared) return steps;
    if (std::fabs(w.path_mm(i) - w.path_mm(k)) > longest) return 0;
  }
  return kOpen;
}

double corner_reach(const KeptSamples& w) noexcept {
  return CornerDetector::kCornerArm * w.tolerance_mm();
}

// Returns the vector from sample k to the point on the last of `steps` steps that is `reach` away.
Vec chord_of(const KeptSamples& w, std::size_t k, Way way, std::size_t steps,
             double reach) noexcept {
  const Point p = w.point(k);
  const Point before = w.point(sample_at(k, way, steps - 1));
  const Point after = w.point(sample_at(k, way, steps));
  const double d0 = distance(p, before), d1 = distance(p, after);
  return lerp(before, after, (reach - d0) / (d1 - d0)) - p;
}

// One arm of the ink at a sample.
struct Arm {
  std::size_t steps = 0;  // number of steps to its last sample; 0 if it has no arm
  Vec chord;              // from the sample to its end
};

Arm find_arm(const KeptSamples& w, std::size_t k, Way way) noexcept {
  const double reach = corner_reach(w);
  const std::size_t steps = steps_to(w, k, way, reach);
  if (steps == 0 || steps == kOpen) return {};
  if (steps > kArmSamples) return {steps, chord_of(w, k, way, steps, reach)};
  return {kArmSamples, w.point(sample_at(k, way, kArmSamples)) - w.point(k)};
}

// Returns how far the samples inside the arm deviate from its chord, as an angle.
double bend(const KeptSamples& w, std::size_t k, Way way, const Arm& arm) noexcept {
  const Point p = w.point(k);
  double largest = 0.0;
  for (std::size_t step = 1; step < arm.steps; ++step) {
    const Point at = w.point(sample_at(k, way, step));
    largest = std::max(largest, distance_to_segment(at, p, p + arm.chord));
  }
  return 2.0 * largest / norm(arm.chord);
}

Vec half_chord(const KeptSamples& w, std::size_t k, Way way, const Arm& arm) noexcept {
  const double reach = 0.5 * norm(arm.chord);
  const std::size_t steps = steps_to(w, k, way, reach);
  return steps == 0 || steps == kOpen ? 0.5 * arm.chord : chord_of(w, k, way, steps, reach);
}

// Returns the turn of the ink at sample k in radians if it may be a corner, or 0 if not.
double corner_turn(const KeptSamples& w, std::size_t k) noexcept {
  // Makes three tests, the cheapest first (see the header): of the turn between the chords, of this
  // turn minus the part that bent arms can cause, and of the turn between arms of half the length.
  const Arm back = find_arm(w, k, Way::kBack);
  if (back.steps == 0) return 0.0;
  const Arm on = find_arm(w, k, Way::kOn);
  if (on.steps == 0) return 0.0;
  // Compares cosines, because nearly all samples return here and an arc tangent is slower.
  static const double cos_limit = std::cos(kCornerRad);
  if (dot(-back.chord, on.chord) > cos_limit * norm(back.chord) * norm(on.chord)) return 0.0;
  const double faked = bend(w, k, Way::kBack, back) + bend(w, k, Way::kOn, on);
  const double turn = angle_between(-back.chord, on.chord) - faked;
  if (!(turn >= kCornerRad)) return 0.0;
  const double near_turn =
      angle_between(-half_chord(w, k, Way::kBack, back), half_chord(w, k, Way::kOn, on));
  return near_turn < CornerDetector::kCornerPersistence * turn ? 0.0 : turn;
}

// Returns true if no other turn within one arm is larger. If two turns are equal, the first one
// counts. Requires that sample k has a turn, and therefore arms.
bool is_largest(const KeptSamples& w, std::size_t k) noexcept {
  const std::size_t back = steps_to(w, k, Way::kBack, corner_reach(w));
  for (std::size_t step = 1; step < back; ++step) {
    if (w.turn(k - step) >= w.turn(k)) return false;
  }
  const std::size_t on = steps_to(w, k, Way::kOn, corner_reach(w));
  for (std::size_t step = 1; step < on; ++step) {
    if (w.turn(k + step) > w.turn(k)) return false;
  }
  return true;
}

}  // namespace

void CornerDetector::clear() noexcept {
  measured_ = 0;
  decided_ = 0;
}

void CornerDetector::update(KeptSamples& w) noexcept {
  measure(w, kMeasuresPerUpdate);
  decide(w);
}

void CornerDetector::measure(KeptSamples& w, std::size_t max_count) noexcept {
  if (w.size() == 0) return;
  const double margin = kCornerMargin * w.tolerance_mm();
  const double newest = w.path_mm(w.size() - 1);
  for (; max_count > 0 && measured_ + kArmSamples < w.size(); --max_count) {
    const double here = w.path_mm(measured_);
    const bool at_start = measured_ < kArmSamples || here < margin;
    if (!at_start) {
      if (newest < here + margin) break;
      if (steps_to(w, measured_, Way::kOn, corner_reach(w)) == kOpen) break;
      w.set_turn(measured_, corner_turn(w, measured_));
    }
    ++measured_;
  }
}

void CornerDetector::decide(KeptSamples& w) noexcept {
  // A sample can be decided once its whole neighbourhood is measured.
  while (decided_ < measured_) {
    if (w.turn(decided_) > 0.0) {
      if (decided_ + steps_to(w, decided_, Way::kOn, corner_reach(w)) > measured_) break;
      if (is_largest(w, decided_)) w.set_corner(decided_);
    }
    ++decided_;
  }
}

void CornerDetector::finish(KeptSamples& w) noexcept {
  measure(w, w.size());
  decide(w);
  for (; decided_ < w.size(); ++decided_) {
    if (w.turn(decided_) > 0.0 && is_largest(w, decided_)) w.set_corner(decided_);
  }
  measured_ = w.size();
}

}  // namespace felt
