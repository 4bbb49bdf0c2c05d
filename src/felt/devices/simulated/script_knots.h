#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "felt/devices/simulated/hand_script.h"

namespace felt {

/// A point of a stroke as a hand draws it: every field finite, times from 0 on, never backwards.
struct ScriptKnot {
  Point position;
  double pressure = 0.5;
  double t_s = 0.0;
};

/// The knots of a recording (hand_script.h says what becomes of its times); empty where nothing of
/// it is usable.
std::vector<ScriptKnot> knots_of(const RecordedPath& path, double absent_pressure);

/// Reads a stroke at growing times, straight between its knots. The knots must outlive it and be at
/// least one.
class KnotReader {
 public:
  explicit KnotReader(const std::vector<ScriptKnot>& knots) : knots_(knots) {}

  ScriptKnot at(double t_s) {
    while (next_ + 1 < knots_.size() && knots_[next_].t_s < t_s) ++next_;
    const ScriptKnot& b = knots_[next_];
    const ScriptKnot& a = knots_[next_ > 0 ? next_ - 1 : 0];
    const double span = b.t_s - a.t_s;
    const double part = span > 0.0 ? std::clamp((t_s - a.t_s) / span, 0.0, 1.0) : 1.0;
    return {lerp(a.position, b.position, part), a.pressure + part * (b.pressure - a.pressure), t_s};
  }

 private:
  const std::vector<ScriptKnot>& knots_;
  std::size_t next_ = 0;
};

}  // namespace felt
