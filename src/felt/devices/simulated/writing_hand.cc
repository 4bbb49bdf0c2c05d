#include "felt/devices/simulated/writing_hand.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "felt/base/constants.h"
#include "felt/devices/simulated/hand_path.h"

namespace felt {
namespace {

constexpr double kGridS = 0.001;   // the aim is smoothed on a grid of 1 ms
constexpr int kMuscleHalfMs = 20;  // half of the smoothing window
constexpr double kRiseS = 0.05;    // rise of the pressure at pen-down
constexpr double kFallS = 0.07;    // fall of the pressure at pen-up
constexpr double kDotS = 0.09;     // duration of a dot

double smooth_step(double x) {
  x = std::clamp(x, 0.0, 1.0);
  return x * x * (3.0 - 2.0 * x);
}

double quantised(double value, double step) {
  return step > 0.0 ? step * std::round(value / step) : value;
}

// Returns a factor for the pressure. It is higher for slow strokes and for strokes towards the body
// (down the page).
double effort(Vec velocity_mm_s) {
  const double speed = norm(velocity_mm_s);
  const double slow = std::pow(60.0 / std::max(speed, 10.0), 0.12);
  return slow * (1.0 + 0.25 * velocity_mm_s.y / std::max(speed, 20.0));
}

}  // namespace

WritingHand::WritingHand(const HandOptions& options)
    : options_(options),
      random_(options.seed),
      tremor_(random_, 8.0, 12.0, options.tremor_mm),
      wander_(random_, 0.4, 2.5, options.wander_mm),
      waver_(random_, 0.7, 4.0, 0.06) {}

// Advances the time by a whole number of sampling intervals, because the tablet's clock continues
// to run while the pen is up.
void WritingHand::rest_until_start_of(Point start) {
  if (!last_) return;
  const double pause_s = random_.between(0.12, 0.25) + distance(*last_, start) / 300.0;
  const double interval_s = static_cast<double>(options_.interval_ns) * 1e-9;
  now_s_ = interval_s * std::ceil((now_s_ + pause_s) / interval_s);
}

std::vector<HandSample> WritingHand::draw(const Gesture& gesture) {
  std::vector<HandSample> samples;
  if (gesture.via.empty()) return samples;
  rest_until_start_of(gesture.via.front());
  const auto plan = at_equal_times(pace(smooth_path(gesture.via), gesture.tempo), kGridS, kDotS);
  const auto track = through_muscles(plan, kMuscleHalfMs);
  const double duration_s = kGridS * static_cast<double>(track.size() - 1);
  const auto start_ns = std::llround(now_s_ * 1e9);
  for (std::int64_t ns = 0; static_cast<double>(ns) * 1e-9 <= duration_s;
       ns += options_.interval_ns) {
    const double t = static_cast<double>(ns) * 1e-9, place = t / kGridS;
    const auto k = std::min(static_cast<std::size_t>(place), track.size() - 1);
    const auto next = std::min(k + 1, track.size() - 1);
    const Point aim = lerp(track[k], track[next], place - static_cast<double>(k));
    const Point p = aim + tremor_.at(now_s_ + t) + wander_.at(now_s_ + t);
    const double ends = std::min(smooth_step(t / kRiseS), smooth_step((duration_s - t) / kFallS));
    const double level = gesture.end_pressure + (1.0 - gesture.end_pressure) * ends;
    const double pressure = gesture.pressure * level * effort((track[next] - track[k]) / kGridS) *
                            (1.0 + waver_.at(now_s_ + t).x);
    samples.push_back({.position = {quantised(p.x, options_.resolution_mm),
                                    quantised(p.y, options_.resolution_mm)},
                       .pressure = quantised(std::clamp(pressure, options_.pressure_step, 1.0),
                                             options_.pressure_step),
                       .time_ns = start_ns + ns});
  }
  now_s_ += duration_s;
  last_ = gesture.via.back();
  return samples;
}

}  // namespace felt
