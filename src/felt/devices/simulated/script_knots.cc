#include "felt/devices/simulated/script_knots.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "felt/devices/simulated/hand_path.h"
#include "felt/geometry/tilt.h"

namespace felt {
namespace {

constexpr double kTopSpeed = 500.0;  // mm/s on the page
constexpr double kPauseS = 1.0;      // longest rest within a stroke
constexpr double kDenseMm = 0.05;    // spacing that `pace` expects
constexpr double kLargestMm = 1e4;   // points farther away are not on a page

bool is_usable(const RecordedPoint& p) {
  return is_finite(p.position) && std::fabs(p.position.x) <= kLargestMm &&
         std::fabs(p.position.y) <= kLargestMm;
}

// Sets the times at which an unhurried hand reaches each of the knots.
void give_pace(std::vector<ScriptKnot>& knots) {
  std::vector<Point> dense;
  std::vector<std::size_t> place;
  for (std::size_t i = 0; i < knots.size(); ++i) {
    const Point to = knots[i].position, from = i > 0 ? knots[i - 1].position : to;
    const auto parts = static_cast<std::size_t>(std::ceil(distance(from, to) / kDenseMm));
    for (std::size_t k = 1; k < parts; ++k) {
      dense.push_back(lerp(from, to, static_cast<double>(k) / static_cast<double>(parts)));
    }
    dense.push_back(to);
    place.push_back(dense.size() - 1);
  }
  const std::vector<TimedPoint> timed = pace(dense, 1.0);
  for (std::size_t i = 0; i < knots.size(); ++i) knots[i].t_s = timed[place[i]].t_s;
}

// Returns the time from one point to the next. It is the recorded time, limited to the speeds and
// pauses of a hand.
double seconds_between(const RecordedPoint& a, const RecordedPoint& b) {
  // Subtracts in double, because the difference of two arbitrary times may not fit into 64 bits.
  const double dt_s = 1e-9 * (static_cast<double>(*b.time_ns) - static_cast<double>(*a.time_ns));
  const double min_s = distance(a.position, b.position) / kTopSpeed;
  return std::clamp(dt_s, min_s, std::max(kPauseS, min_s));
}

// Returns true if the times of a stroke are usable: all are present, they never decrease, and they
// are not all equal.
bool has_pace(const RecordedPath& usable) {
  for (std::size_t i = 0; i < usable.size(); ++i) {
    if (!usable[i].time_ns) return false;
    if (i > 0 && *usable[i].time_ns < *usable[i - 1].time_ns) return false;
  }
  return usable.size() < 2 || *usable.front().time_ns < *usable.back().time_ns;
}

}  // namespace

std::vector<ScriptKnot> knots_of(const RecordedPath& path, double absent_pressure) {
  RecordedPath usable;
  std::copy_if(path.begin(), path.end(), std::back_inserter(usable), is_usable);
  const bool paced = has_pace(usable);
  std::vector<ScriptKnot> knots;
  double t_s = 0.0;
  for (std::size_t i = 0; i < usable.size(); ++i) {
    const RecordedPoint& p = usable[i];
    if (paced && i > 0) t_s += seconds_between(usable[i - 1], p);
    const double pressure =
        p.pressure && std::isfinite(*p.pressure) ? *p.pressure : absent_pressure;
    knots.push_back({p.position, std::clamp(pressure, 0.0, 1.0), t_s, checked_tilt(p.tilt_deg)});
  }
  if (!paced) give_pace(knots);
  return knots;
}

}  // namespace felt
