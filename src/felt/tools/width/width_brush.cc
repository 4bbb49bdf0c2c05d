#include "felt/tools/width/width_brush.h"

#include <algorithm>
#include <cmath>

#include "felt/stroke/width_profile.h"
#include "felt/tools/brush_bump.h"

namespace felt {
namespace {

/// Knots within kSamePlace in u count as one, because a point cannot have two widths.
constexpr double kSamePlace = 1e-9;

}  // namespace

WidthBrush::WidthBrush(const Stroke& stroke, const ArcMap& map, double reach_mm,
                       double max_width_mm)
    : stroke_(stroke),
      map_(map),
      reach_mm_(reach_mm),
      max_width_mm_(max_width_mm),
      places_(stroke, map, std::min(kSpacingMm, reach_mm / kPlacesPerReach)),
      added_(places_.slot_count(), 0.0) {}

double WidthBrush::limited(double base_mm, double added_mm) const noexcept {
  // A place to which nothing was added keeps its width. The maximum is needed because interpolation
  // between two knots of 0.05 mm may give slightly less by rounding.
  if (added_mm == 0.0) return std::max(base_mm, kMinWidthMm);
  return std::clamp(base_mm + added_mm, kMinWidthMm, std::max(max_width_mm_, base_mm));
}

void WidthBrush::add(double u, double length_mm, double amount_mm) {
  const double h = places_.spacing_mm();
  long first = static_cast<long>(std::floor((length_mm - reach_mm_) / h));
  long last = static_cast<long>(std::ceil((length_mm + reach_mm_) / h));
  if (stroke_.closed()) {
    const long here = places_.cell(length_mm), half = places_.count() / 2;
    first = std::max(first, here - half);
    last = std::min(last, first + places_.count() - 1);
  } else {
    first = std::max(first, 0L);
    last = std::min(last, places_.count());
  }
  const auto share = [&](long k) {
    const double way = map_.way(length_mm, places_.length_at(k));
    return bump(std::fabs(way) / reach_mm_);
  };
  const long cell = places_.cell(length_mm);
  const double u0 = places_.u(cell), u1 = places_.u(cell + 1);
  const double tw = std::clamp((u - u0) / (u1 - u0), 0.0, 1.0);
  const double own = (1.0 - tw) * share(cell) + tw * share(cell + 1);
  // On a line of 100 km the places may be farther apart than the reach, so that no place is within
  // it.
  if (!(own > 0.0)) return;
  for (long k = first; k <= last; ++k) {
    const double change = amount_mm * share(k) / own;
    if (change == 0.0) continue;
    double& added = added_[places_.slot(k)];
    const double base = width_at(stroke_.widths(), places_.u(static_cast<long>(places_.slot(k))));
    // Amounts beyond the limits are not accumulated, so that a change of direction takes effect
    // immediately.
    added = limited(base, added + change) - base;
  }
}

double WidthBrush::width_mm(double u, double length_mm) const {
  const long cell = places_.cell(length_mm);
  const double a = added_[places_.slot(cell)], b = added_[places_.slot(cell + 1)];
  const double base = stroke_.width_mm(u);
  if (a == 0.0 && b == 0.0) return base;
  const double u0 = places_.u(cell), u1 = places_.u(cell + 1);
  const double tw = std::clamp((u - u0) / (u1 - u0), 0.0, 1.0);
  return limited(base, (1.0 - tw) * a + tw * b);
}

std::vector<WidthKnot> WidthBrush::added_knots() const {
  const auto at = [&](long k) { return added_[places_.slot(k)]; };
  std::vector<WidthKnot> knots;
  const long n = places_.count();
  for (long k = 0; k <= n; ++k) {
    const bool counts = at(k) != 0.0 || (k > 0 && at(k - 1) != 0.0) || (k < n && at(k + 1) != 0.0);
    if (counts) knots.push_back({places_.u(k), at(k)});
  }
  return knots;
}

/// Merges the stroke's breakpoints, the pinned parameters and the knots of the added widths by u,
/// then drops the knots that are not needed.
std::vector<WidthKnot> WidthBrush::profile(std::span<const double> pinned) const {
  const std::span<const WidthKnot> base = stroke_.widths();
  const std::vector<WidthKnot> added = added_knots();
  if (added.empty()) return {base.begin(), base.end()};
  std::vector<ProfileKnot> knots;
  knots.reserve(base.size() + added.size() + pinned.size());
  std::size_t i = 0, j = 0, p = 0;
  const auto added_at = [&](double u) {
    // Nothing was added before the first and after the last of the added knots.
    return u < added.front().u || u > added.back().u ? 0.0 : width_at(added, u);
  };
  const auto push = [&](const WidthKnot& ink, bool is_base, bool stays) {
    if (!knots.empty() && ink.u - knots.back().knot.u < kSamePlace && !is_base) return;
    const double more = added_at(ink.u);
    knots.push_back({{ink.u, limited(ink.width_mm, more), ink.tone}, stays || more == 0.0});
  };
  while (i < base.size()) {
    const double u = base[i].u;
    while (p < pinned.size() && pinned[p] < u - kSamePlace &&
           (j == added.size() || pinned[p] <= added[j].u)) {
      push(knot_at(base, pinned[p]), false, true);
      ++p;
    }
    if (j < added.size() && added[j].u < u - kSamePlace) {
      push(knot_at(base, added[j].u), false, false);
      ++j;
      continue;
    }
    push(base[i], true, false);
    ++i;
    while (j < added.size() && added[j].u < u + kSamePlace) ++j;
    while (p < pinned.size() && pinned[p] < u + kSamePlace) ++p;
  }
  return thinned(knots, kToleranceMm);
}

}  // namespace felt
