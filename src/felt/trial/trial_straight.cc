#include <cmath>

#include "felt/trial/trial_parts.h"

namespace felt {
namespace {

constexpr double kStillMm = 1e-9;  // less is rounding

// Counts changes between positive and negative numbers. Skips zeros.
class SignChanges {
 public:
  void add(double value) noexcept {
    if (std::abs(value) <= kStillMm) return;
    const int sign = value > 0.0 ? 1 : -1;
    if (sign == -last_) ++count_;
    last_ = sign;
  }
  [[nodiscard]] double count() const noexcept { return count_; }

 private:
  int last_ = 0;
  double count_ = 0.0;
};

double reentries(const TrialInk& ink, Point target, double radius_mm) {
  double entries = 0.0;
  bool inside = false;
  for (const Point p : ink.points) {
    const bool now = distance(p, target) <= radius_mm + kStillMm;
    if (now && !inside) ++entries;
    inside = now;
  }
  return std::max(0.0, entries - 1.0);
}

}  // namespace

void measure_straight(const TrialInk& ink, const TrialPath& path, const TrialGeometry& geometry,
                      TrialMetrics& metrics) {
  const Point start = path.line().front(), target = path.line().back();
  const Vec axis = normalized(target - start);
  SignChanges crossings, across, along;
  double sum = 0.0, absolute = 0.0;
  std::vector<double> offsets;
  for (std::size_t i = 0; i < ink.points.size(); ++i) {
    const double y = cross(axis, ink.points[i] - start);
    offsets.push_back(y);
    sum += y;
    absolute += std::abs(y);
    crossings.add(y);
    if (i == 0) continue;
    const Vec step = ink.points[i] - ink.points[i - 1];
    across.add(cross(axis, step));
    along.add(dot(axis, step));
  }
  const auto count = static_cast<double>(offsets.size());
  const double mean = sum / count;
  double squares = 0.0;
  for (const double y : offsets) squares += (y - mean) * (y - mean);
  if (geometry.target_width_mm)
    metrics.target_reentries = reentries(ink, target, 0.5 * *geometry.target_width_mm);
  metrics.axis_crossings = crossings.count();
  metrics.direction_changes = across.count();
  metrics.orthogonal_changes = along.count();
  metrics.movement_error_mm = absolute / count;
  metrics.movement_offset_mm = mean;
  if (offsets.size() > 1) metrics.movement_variability_mm = std::sqrt(squares / (count - 1.0));
}

}  // namespace felt
