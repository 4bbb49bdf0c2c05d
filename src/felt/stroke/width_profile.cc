#include "felt/stroke/width_profile.h"

#include <algorithm>

namespace felt {

double width_at(std::span<const WidthKnot> profile, double u) noexcept {
  if (profile.empty()) return 0.0;
  if (!(u > profile.front().u)) return profile.front().width_mm;
  if (u >= profile.back().u) return profile.back().width_mm;
  const auto after = std::upper_bound(profile.begin(), profile.end(), u,
                                      [](double x, const WidthKnot& knot) { return x < knot.u; });
  const WidthKnot& k1 = *(after - 1);
  const WidthKnot& k2 = *after;
  const double tw = (u - k1.u) / (k2.u - k1.u);
  return (1.0 - tw) * k1.width_mm + tw * k2.width_mm;
}

}  // namespace felt
