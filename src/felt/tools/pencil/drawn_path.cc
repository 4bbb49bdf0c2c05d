#include "felt/tools/pencil/drawn_path.h"

#include <algorithm>

namespace felt {
namespace {

double median_of(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace

void DrawnPath::begin() noexcept {
  points_.clear();
  inks_.clear();
}

void DrawnPath::push(Point at, const InkWidth& ink) {
  if (points_.size() > kMaxPoints) return;
  if (!points_.empty() && distance(points_.back(), at) <= kStepMm) return;
  points_.push_back(at);
  inks_.push_back(ink);
}

std::span<const Point> DrawnPath::points() const noexcept {
  if (points_.size() > kMaxPoints) return {};
  return points_;
}

InkWidth DrawnPath::usual_ink() const {
  std::vector<double> widths, tones;
  for (const InkWidth& ink : inks_) {
    widths.push_back(ink.width_mm);
    tones.push_back(ink.tone);
  }
  return {median_of(std::move(widths)), median_of(std::move(tones))};
}

}  // namespace felt
