#include "felt/devices/simulated/script_knots.h"

#include <cmath>
#include <optional>

#include "felt/devices/simulated/hand_path.h"

namespace felt {
namespace {

constexpr double kTopSpeed = 500.0;  // mm/s on the sheet
constexpr double kPauseS = 1.0;      // longest rest within a stroke
constexpr double kDenseMm = 0.05;    // what `pace` expects
constexpr double kLargestMm = 1e4;   // points farther away are no points of a sheet

bool is_usable(const RecordedPoint& p) {
  return is_finite(p.position) && std::fabs(p.position.x) <= kLargestMm &&
         std::fabs(p.position.y) <= kLargestMm;
}

// Where an unhurried hand would be when, at each of the knots.
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

}  // namespace

std::vector<ScriptKnot> knots_of(const RecordedPath& path, double absent_pressure) {
  std::vector<ScriptKnot> knots;
  bool timed = true;
  std::optional<std::int64_t> first_ns, last_ns;
  double t_s = 0.0;
  for (const RecordedPoint& p : path) {
    if (!is_usable(p)) continue;
    timed = timed && p.time_ns && (!last_ns || *p.time_ns >= *last_ns);
    if (timed && last_ns) {
      // In double: the difference of two hostile times does not fit into 64 bits.
      const double dt_s = 1e-9 * (static_cast<double>(*p.time_ns) - static_cast<double>(*last_ns));
      t_s += std::clamp(dt_s, distance(knots.back().position, p.position) / kTopSpeed,
                        std::max(kPauseS, distance(knots.back().position, p.position) / kTopSpeed));
    }
    const double pressure =
        p.pressure && std::isfinite(*p.pressure) ? *p.pressure : absent_pressure;
    knots.push_back({p.position, std::clamp(pressure, 0.0, 1.0), t_s});
    last_ns = p.time_ns;
    if (!first_ns) first_ns = last_ns;
  }
  const bool stands_still = knots.size() > 1 && first_ns == last_ns;
  if (!timed || stands_still) give_pace(knots);
  return knots;
}

}  // namespace felt
