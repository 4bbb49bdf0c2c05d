#include "felt/tools/width/profile_knots.h"

#include <algorithm>
#include <limits>

namespace felt {
namespace {

/// Longest run of knots that one straight line replaces: bounds the work.
constexpr std::size_t kMaxRun = 200;

/// The farthest knot after `i` to which a straight line does.
std::size_t farthest(std::span<const ProfileKnot> knots, std::size_t i, double tolerance_mm) {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  const WidthKnot from = knots[i].knot;
  const std::size_t end = std::min(knots.size(), i + kMaxRun);
  std::size_t best = i + 1;
  for (std::size_t j = i + 1; j < end; ++j) {
    const WidthKnot to = knots[j].knot;
    const double du = to.u - from.u, dw = to.width_mm - from.width_mm;
    if (dw / du >= low && dw / du <= high) best = j;
    low = std::max(low, (dw - tolerance_mm) / du);
    high = std::min(high, (dw + tolerance_mm) / du);
    if (knots[j].stays || low > high) break;
  }
  return best;
}

}  // namespace

std::vector<WidthKnot> thinned(std::span<const ProfileKnot> knots, double tolerance_mm) {
  std::vector<WidthKnot> result;
  if (knots.empty()) return result;
  result.push_back(knots.front().knot);
  for (std::size_t i = 0; i + 1 < knots.size();) {
    i = farthest(knots, i, tolerance_mm);
    result.push_back(knots[i].knot);
  }
  return result;
}

std::vector<WidthKnot> scaled(std::span<const WidthKnot> knots, double factor,
                              double max_width_mm) {
  std::vector<WidthKnot> result(knots.begin(), knots.end());
  for (WidthKnot& knot : result) {
    const double most = std::max(max_width_mm, knot.width_mm);
    knot.width_mm = std::clamp(factor * knot.width_mm, kMinWidthMm, most);
  }
  return result;
}

}  // namespace felt
