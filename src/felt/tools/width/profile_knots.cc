#include "felt/tools/width/profile_knots.h"

#include <algorithm>
#include <limits>

#include "felt/stroke/profile_builder.h"

namespace felt {
namespace {

/// Maximum number of knots that one straight line replaces. This limits the time per knot.
constexpr std::size_t kMaxRun = 200;

/// The interval of slopes of the straight lines from a knot that pass all knots added so far within
/// a tolerance.
struct KnotSlopes {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();

  [[nodiscard]] bool hold(double slope) const noexcept { return slope >= low && slope <= high; }
  [[nodiscard]] bool is_empty() const noexcept { return low > high; }
  void narrow(double change, double tolerance, double du) noexcept {
    low = std::max(low, (change - tolerance) / du);
    high = std::min(high, (change + tolerance) / du);
  }
};

/// Returns the farthest knot after `i` to which a straight line may go.
std::size_t farthest(std::span<const ProfileKnot> knots, std::size_t i, double tolerance_mm) {
  KnotSlopes widths, tones;
  const WidthKnot from = knots[i].knot;
  const std::size_t end = std::min(knots.size(), i + kMaxRun);
  std::size_t best = i + 1;
  for (std::size_t j = i + 1; j < end; ++j) {
    const WidthKnot to = knots[j].knot;
    const double du = to.u - from.u;
    const double dw = to.width_mm - from.width_mm, dt = to.tone - from.tone;
    if (widths.hold(dw / du) && tones.hold(dt / du)) best = j;
    widths.narrow(dw, tolerance_mm, du);
    tones.narrow(dt, kFollowedTone, du);
    if (knots[j].stays || widths.is_empty() || tones.is_empty()) break;
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
    const double largest = std::max(max_width_mm, knot.width_mm);
    knot.width_mm = std::clamp(factor * knot.width_mm, kMinWidthMm, largest);
  }
  return result;
}

}  // namespace felt
