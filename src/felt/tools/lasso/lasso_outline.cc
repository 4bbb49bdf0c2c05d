#include "felt/tools/lasso/lasso_outline.h"

#include <algorithm>

#include "felt/geometry/polyline.h"

namespace felt {
namespace {

/// Points nearer than kSpacingMm to the last point are skipped. The sum of this error and the error
/// of the simplification stays within the tolerance.
constexpr double kSpacingMm = 0.05;
constexpr double kSimplifyMm = LassoOutline::kToleranceMm - kSpacingMm;
/// Number of points that are simplified together, which takes at most 30 us.
constexpr std::size_t kTail = 96;

}  // namespace

void LassoOutline::begin(Point p) {
  clear();
  points_.push_back(p);
  bounds_.extend(p);
}

void LassoOutline::add(Point p) {
  bounds_.extend(p);
  if (!points_.empty() && distance(points_.back(), p) < kSpacingMm) return;
  points_.push_back(p);
  if (points_.size() - simplified_ > kTail) simplify_tail();
}

void LassoOutline::clear() {
  points_.clear();
  simplified_ = 0;
  bounds_ = {};
}

std::vector<Point> LassoOutline::finished() const {
  LassoOutline whole = *this;
  whole.simplify_tail();
  return std::move(whole.points_);
}

void LassoOutline::simplify_tail() {
  const auto tail = points_.begin() + static_cast<std::ptrdiff_t>(simplified_);
  const std::vector<Point> kept =
      simplified(std::span<const Point>(points_).subspan(simplified_), kSimplifyMm);
  points_.erase(std::copy(kept.begin(), kept.end(), tail), points_.end());
  simplified_ = points_.empty() ? 0 : points_.size() - 1;
}

}  // namespace felt
