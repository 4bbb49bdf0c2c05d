#include "felt/render/tip_travel.h"

#include <algorithm>

namespace felt {

double segment_travel(const Cubic& px, double radius0_px, double radius1_px) noexcept {
  const double around = norm(px.p[1] - px.p[0]) + norm(px.p[2] - px.p[1]) + norm(px.p[3] - px.p[2]);
  // The length of a cubic is between that of its chord and that of its control polygon.
  const double length = 0.5 * (norm(px.p[3] - px.p[0]) + around);
  return length / (radius0_px + radius1_px + 2.0 * kRimPx);
}

void set_travel(std::span<TipAt> dabs, double start, double travel) noexcept {
  if (dabs.empty()) return;
  dabs[0].travel = 0.0;
  for (std::size_t i = 1; i < dabs.size(); ++i) {
    const double width = dabs[i - 1].radius_px + dabs[i].radius_px + 2.0 * kRimPx;
    dabs[i].travel = dabs[i - 1].travel + norm(dabs[i].center_px - dabs[i - 1].center_px) / width;
  }
  const double all = dabs.back().travel;
  const double scale = all > 0.0 ? travel / all : 0.0;
  for (TipAt& dab : dabs) dab.travel = start + scale * dab.travel;
}

}  // namespace felt
