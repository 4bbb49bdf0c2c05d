#include "felt/tools/width/arc_places.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace felt {

ArcPlaces::ArcPlaces(const Stroke& stroke, const ArcMap& map, double spacing_mm)
    : map_(map), closed_(stroke.closed()), segments_(stroke.segment_count()) {
  // Makes at least two cells, so that the cells on the two sides of a place differ.
  count_ = std::max(2L, std::lround(std::min(map.length_mm() / spacing_mm, 1e7)));
  spacing_mm_ = map.length_mm() / static_cast<double>(count_);
  us_.assign(static_cast<std::size_t>(count_ + 1), std::numeric_limits<double>::quiet_NaN());
  us_.front() = 0.0;
  us_.back() = segments_;
}

double ArcPlaces::u(long k) const {
  double& u = us_[static_cast<std::size_t>(k)];
  if (std::isnan(u)) u = map_.u_at(length_at(k));
  return u;
}

long ArcPlaces::cell(double length_mm) const noexcept {
  return std::clamp(static_cast<long>(length_mm / spacing_mm_), 0L, count_ - 1);
}

std::size_t ArcPlaces::slot(long k) const noexcept {
  if (!closed_) return static_cast<std::size_t>(std::clamp(k, 0L, count_));
  const long rest = k % count_;
  return static_cast<std::size_t>(rest < 0 ? rest + count_ : rest);
}

}  // namespace felt
