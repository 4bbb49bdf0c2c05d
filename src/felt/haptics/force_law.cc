#include "felt/haptics/force_law.h"

#include <algorithm>
#include <cmath>

namespace felt {

double ForceLaw::level_n(double distance_mm) const noexcept {
  return min_n + (max_n - min_n) * (distance_mm / (distance_mm + spread_mm));
}

double ForceLaw::force_n(double distance_mm) const noexcept {
  if (!(distance_mm > 0.0)) return 0.0;
  if (form == LawForm::kPaper) return gain * level_n(distance_mm);
  return gain * std::min(level_n(distance_mm), 1e-3 * cap_n_per_m * distance_mm);
}

double ForceLaw::potential_mj(double distance_mm) const noexcept {
  if (!(distance_mm > 0.0)) return 0.0;
  if (form == LawForm::kPaper) {
    return gain * (max_n * distance_mm -
                   (max_n - min_n) * spread_mm * std::log1p(distance_mm / spread_mm));
  }
  // The spring and the level l(d) meet at the distance d with c d = a + b d/(d + D), a quadratic
  // equation in d.
  const double c = 1e-3 * cap_n_per_m;
  const double p = c * spread_mm - max_n;
  const double meet_mm = (-p + std::sqrt(p * p + 4.0 * c * min_n * spread_mm)) / (2.0 * c);
  const double sprung_mm = std::min(distance_mm, meet_mm);
  double energy = 0.5 * c * sprung_mm * sprung_mm;
  if (distance_mm > meet_mm) {
    energy +=
        max_n * (distance_mm - meet_mm) -
        (max_n - min_n) * spread_mm * std::log((distance_mm + spread_mm) / (meet_mm + spread_mm));
  }
  return gain * energy;
}

ForceLaw ForceLaw::softened(double share) const noexcept {
  ForceLaw law = *this;
  law.cap_n_per_m *= share;
  return law;
}

double ForceLaw::max_slope_n_per_m() const noexcept {
  // The level l is concave and positive at 0. So it is flatter than the spring at the distance
  // where the two meet.
  return gain * cap_n_per_m;
}

}  // namespace felt
