#include "felt/tactile/line_widths.h"

#include <algorithm>
#include <cstddef>

#include "felt/tactile/swell_paper.h"
#include "felt/tactile/tactile_check.h"

namespace felt {
namespace {

/// Lines of one style: the sum and the number of their widths.
struct WidthGroup {
  double from_mm, to_mm, sum_mm;
  std::size_t count;

  [[nodiscard]] double mean_mm() const noexcept { return sum_mm / static_cast<double>(count); }
};

}  // namespace

std::vector<LineStyle> line_styles_of(std::vector<double> widths_mm) {
  std::sort(widths_mm.begin(), widths_mm.end());
  std::vector<WidthGroup> groups;
  for (const double w : widths_mm) {
    if (groups.empty() || w - groups.back().from_mm >= TactileLimits::kStyleMm) {
      groups.push_back({w, w, 0.0, 0});
    }
    groups.back().to_mm = w;
    groups.back().sum_mm += w;
    ++groups.back().count;
  }
  while (groups.size() > TactileLimits::kLineStyles) {
    std::size_t best = 0;
    for (std::size_t i = 1; i + 1 < groups.size(); ++i) {
      if (groups[i + 1].mean_mm() - groups[i].mean_mm() <
          groups[best + 1].mean_mm() - groups[best].mean_mm()) {
        best = i;
      }
    }
    WidthGroup& low = groups[best];
    const WidthGroup& high = groups[best + 1];
    low = {low.from_mm, high.to_mm, low.sum_mm + high.sum_mm, low.count + high.count};
    groups.erase(groups.begin() + static_cast<std::ptrdiff_t>(best) + 1);
  }
  std::vector<LineStyle> styles;
  double least_mm = SwellRules::kLineMm;
  for (const WidthGroup& group : groups) {
    const double width_mm = std::max(least_mm, group.mean_mm());
    styles.push_back({group.from_mm, group.to_mm, width_mm});
    least_mm = width_mm + TactileLimits::kStyleMm;
  }
  return styles;
}

}  // namespace felt
