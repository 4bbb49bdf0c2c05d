#include "felt/tools/line_stabiliser.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace felt {
namespace {

constexpr double kStepS = 0.001;
/// Maximum number of steps between two samples. After this many steps the nib has practically
/// reached the pen.
constexpr int kMaxSteps = 100;
/// Step length of the part of a line that is added at pen-up, as if a slow hand had drawn it.
constexpr double kRestStepMm = 0.1;
constexpr int kMaxRestSteps = 2000;
constexpr double kArrivedMm = 0.02;

}  // namespace

InertiaOptions inertia_of(const StabiliserOptions& options) noexcept {
  InertiaOptions inertia;
  inertia.mass_kg = 1e-3 * options.mass_g;
  inertia.drag_n_s_per_m = std::max(
      inertia.drag_n_s_per_m,
      2.0 * std::sqrt(inertia.stiffness_n_per_m * inertia.mass_kg) - inertia.damping_n_s_per_m);
  return inertia;
}

TowOptions tow_of(const StabiliserOptions& options) noexcept {
  TowOptions tow;
  tow.rope_mm = options.length_mm;
  return tow;
}

void Stabiliser::begin(Point pen, std::int64_t time_ns) noexcept {
  pen_ = pen;
  nib_ = {.position = pen, .velocity = {}, .gesture = 0, .is_set = true};
  time_ns_ = time_ns;
}

Point Stabiliser::update(Point pen, std::int64_t time_ns) noexcept {
  const double dt_s =
      std::clamp(1e-9 * (static_cast<double>(time_ns) - static_cast<double>(time_ns_)),
                 0.2 * kStepS, kMaxSteps * kStepS);
  const int steps = static_cast<int>(std::ceil(dt_s / kStepS - 1e-6));
  const Vec velocity = (pen - pen_) / dt_s;
  for (int i = 1; i <= steps; ++i) {
    follow(lerp(pen_, pen, static_cast<double>(i) / steps), velocity, dt_s / steps);
  }
  pen_ = pen;
  time_ns_ = time_ns;
  return nib_.position;
}

void Stabiliser::follow(Point pen, Vec pen_velocity_mm_per_s, double dt_s) noexcept {
  switch (options_.kind) {
    case StabiliserKind::kOff:
      nib_.position = pen;
      return;
    case StabiliserKind::kTowed:
      nib_.position = towed_nib(tow_of(options_), nib_.position, pen, dt_s);
      return;
    case StabiliserKind::kInertia:
      move_mass(inertia_of(options_), nib_, pen, pen_velocity_mm_per_s, dt_s);
      return;
  }
}

void Stabiliser::finish(std::vector<Step>& rest) {
  rest.clear();
  if (nib_.position == pen_) return;
  constexpr auto kStepNs = static_cast<std::int64_t>(1e9 * kStepS);
  std::int64_t time_ns = time_ns_;
  Point last = nib_.position;
  for (int i = 1; i < kMaxRestSteps && distance(nib_.position, pen_) > kArrivedMm; ++i) {
    if (options_.kind == StabiliserKind::kTowed) {
      // With a rope of constant length the nib would stop one rope length away from the pen, so the
      // rope is shortened.
      const Vec rope = pen_ - nib_.position;
      nib_.position += std::min(1.0, kRestStepMm / norm(rope)) * rope;
    } else {
      follow(pen_, {}, kStepS);
    }
    if (time_ns <= std::numeric_limits<std::int64_t>::max() - kStepNs) time_ns += kStepNs;
    if (distance(last, nib_.position) < kRestStepMm) continue;
    rest.push_back({nib_.position, time_ns});
    last = nib_.position;
  }
  rest.push_back({pen_, time_ns});
  nib_.position = pen_;
}

}  // namespace felt
