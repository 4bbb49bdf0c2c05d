#include "felt/solid/line_density.h"

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <vector>

#include "felt/geometry/cubic.h"
#include "felt/geometry/rect.h"

namespace felt {

Result<void> check_line_density(std::span<const FillLine> lines) {
  constexpr double kCells = 256.0, kMaxPasses = 20.0;
  constexpr std::size_t kMaxDenseCells = 500;
  Rect box;
  for (const FillLine& line : lines) box.extend(line.stroke->bounds());
  const double cell_mm = std::max({box.width(), box.height(), 1e-6}) / kCells;
  constexpr auto kColumns = static_cast<std::size_t>(kCells) + 1;
  std::vector<double> length_mm(kColumns * kColumns, 0.0);
  const auto cell_of = [&](Point p) {
    const auto number = [&](double v) {
      return static_cast<std::size_t>(std::clamp(v / cell_mm, 0.0, kCells));
    };
    return number(p.y - box.y0) * kColumns + number(p.x - box.x0);
  };
  for (const FillLine& line : lines) {
    for (int i = 0; i < line.stroke->segment_count(); ++i) {
      const Cubic c = line.stroke->segment(i);
      const double chord_mm = distance(c.p[0], c.p[3]);
      const int steps = 1 + static_cast<int>(std::min(2.0 * chord_mm / cell_mm, 4.0 * kCells));
      for (int k = 0; k < steps; ++k) {
        length_mm[cell_of(lerp(c.p[0], c.p[3], (k + 0.5) / steps))] += chord_mm / steps;
      }
    }
  }
  const double limit_mm = kMaxPasses * cell_mm;
  const auto dense = std::count_if(length_mm.begin(), length_mm.end(),
                                   [&](double length) { return length > limit_mm; });
  if (static_cast<std::size_t>(dense) <= kMaxDenseCells) return {};
  const auto worst = static_cast<std::size_t>(std::max_element(length_mm.begin(), length_mm.end()) -
                                              length_mm.begin());
  const Point at{box.x0 + (0.5 + static_cast<double>(worst % kColumns)) * cell_mm,
                 box.y0 + (0.5 + static_cast<double>(worst / kColumns)) * cell_mm};
  char text[200];
  std::snprintf(
      text, sizeof text,
      "the lines are too dense at (%.2f, %.2f) mm to find an outline: %.1f mm of line within "
      "%.2f mm, but at most %.1f mm can be; smooth the line",
      at.x, at.y, length_mm[worst], cell_mm, limit_mm);
  return fail(ErrorCode::kLimitExceeded, text);
}

}  // namespace felt
