#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

#include "felt/devices/simulated/scripted_hand.h"

namespace felt {

/// A point of a stroke to draw. Every field is finite; times start at 0 and never decrease.
struct ScriptKnot {
  Point position;
  double pressure = 0.5;
  double t_s = 0.0;
  std::optional<double> tilt_deg{};
};

/// Returns the knots of a recorded stroke. See script_hand() for how the recorded times are used.
/// The result is empty if no point is usable.
std::vector<ScriptKnot> knots_of(const RecordedPath& path, double absent_pressure);

/// Interpolates a stroke linearly between its knots, at increasing times. Requires at least one
/// knot. The knots must outlive the reader.
class KnotReader {
 public:
  explicit KnotReader(const std::vector<ScriptKnot>& knots) : knots_(knots) {}

  ScriptKnot at(double t_s) {
    while (next_ + 1 < knots_.size() && knots_[next_].t_s < t_s) ++next_;
    const ScriptKnot& b = knots_[next_];
    const ScriptKnot& a = knots_[next_ > 0 ? next_ - 1 : 0];
    const double span = b.t_s - a.t_s;
    const double part = span > 0.0 ? std::clamp((t_s - a.t_s) / span, 0.0, 1.0) : 1.0;
    ScriptKnot knot = b;
    knot.position = lerp(a.position, b.position, part);
    knot.pressure = a.pressure + part * (b.pressure - a.pressure);
    knot.t_s = t_s;
    if (a.tilt_deg && b.tilt_deg) knot.tilt_deg = std::lerp(*a.tilt_deg, *b.tilt_deg, part);
    return knot;
  }

 private:
  const std::vector<ScriptKnot>& knots_;
  std::size_t next_ = 0;
};

}  // namespace felt
