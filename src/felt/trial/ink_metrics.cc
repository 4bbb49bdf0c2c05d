#include "felt/trial/ink_metrics.h"

#include <algorithm>
#include <cmath>

#include "felt/geometry/polyline.h"
#include "felt/trial/line_tree.h"

namespace felt {
namespace {

constexpr double kRoundingSlack = 1e-9;  // so that 20 mm have 40 steps of 0.5 mm despite rounding

int equal_steps(double length_mm, double step_mm) {
  return std::max(1, static_cast<int>(std::ceil(length_mm / step_mm - kRoundingSlack)));
}

/// Returns the width of a line at a distance from its first point.
double width_at(const InkLine& line, double at_mm) {
  double start_mm = 0.0;
  for (std::size_t i = 1; i < line.points.size(); ++i) {
    const double step_mm = distance(line.points[i - 1], line.points[i]);
    if (step_mm > 0.0 && start_mm + step_mm >= at_mm) {
      return std::lerp(line.widths_mm[i - 1], line.widths_mm[i], (at_mm - start_mm) / step_mm);
    }
    start_mm += step_mm;
  }
  return line.widths_mm.back();
}

LineTree tree_of_lines(std::span<const InkLine> ink) {
  std::vector<LineTree::Line> lines;
  for (const InkLine& line : ink) {
    for (std::size_t i = 1; i < line.points.size(); ++i) {
      lines.push_back({line.points[i - 1], line.points[i]});
    }
  }
  return LineTree(std::move(lines));
}

/// The erased and the remaining length of a part of a line.
struct ErasedLength {
  double erased_mm = 0.0, left_mm = 0.0;
};

/// Returns the lengths between two distances along a line.
ErasedLength erased_of(std::span<const Point> line, double from_mm, double to_mm,
                       const LineTree& ink) {
  ErasedLength sum;
  if (!(to_mm > from_mm)) return sum;
  const int steps = equal_steps(to_mm - from_mm, kErasedStepMm);
  const double step_mm = (to_mm - from_mm) / steps;
  for (int i = 0; i < steps; ++i) {
    const Point middle = point_at_length(line, from_mm + (i + 0.5) * step_mm);
    const bool is_left = ink.nearest(middle).distance_squared <= kSameInkMm * kSameInkMm;
    (is_left ? sum.left_mm : sum.erased_mm) += step_mm;
  }
  return sum;
}

}  // namespace

void measure_closing(std::span<const InkLine> ink, TrialMetrics& metrics) {
  if (ink.empty()) return;
  std::vector<Point> ends;
  for (const InkLine& line : ink) {
    if (line.is_closed) continue;
    ends.push_back(line.points.front());
    ends.push_back(line.points.back());
  }
  const auto meets_another = [&ends](const Point& end) {
    return std::any_of(ends.begin(), ends.end(), [&end](const Point& other) {
      return &other != &end && distance(other, end) <= kMeetingEndsMm;
    });
  };
  metrics.is_closed = std::all_of(ends.begin(), ends.end(), meets_another) ? 1.0 : 0.0;
}

void measure_width(std::span<const InkLine> ink, double required_mm, TrialMetrics& metrics) {
  std::vector<double> widths;
  for (const InkLine& line : ink) {
    const double inner_mm = polyline_length(line.points) - 2.0 * kWidthEndMm;
    if (!(inner_mm > 0.0)) continue;
    const int steps = equal_steps(inner_mm, kWidthStepMm);
    for (int i = 0; i <= steps; ++i) {
      widths.push_back(width_at(line, kWidthEndMm + inner_mm * i / steps));
    }
  }
  if (widths.empty()) return;
  const auto count = static_cast<double>(widths.size());
  double sum = 0.0, error = 0.0, squares = 0.0;
  for (const double width : widths) {
    sum += width;
    error += std::abs(width - required_mm);
  }
  const double mean = sum / count;
  for (const double width : widths) squares += (width - mean) * (width - mean);
  metrics.width_mean_mm = mean;
  metrics.width_err_mm = error / count;
  if (mean > 0.0) metrics.width_cv = std::sqrt(squares / (count - 1.0)) / mean;
}

void measure_erasing(const ErasedPage& before, std::span<const InkLine> ink,
                     TrialMetrics& metrics) {
  const LineTree tree = tree_of_lines(ink);
  const double length_mm = polyline_length(before.line);
  double extra_mm = erased_of(before.line, 0.0, before.from_mm, tree).erased_mm +
                    erased_of(before.line, before.to_mm, length_mm, tree).erased_mm;
  double wrong = 0.0;
  for (const std::vector<Point>& line : before.others) {
    const double lost_mm = erased_of(line, 0.0, polyline_length(line), tree).erased_mm;
    extra_mm += lost_mm;
    if (lost_mm > kTouchedMm + kRoundingSlack) wrong += 1.0;
  }
  metrics.erased_extra_mm = extra_mm;
  metrics.erased_left_mm = erased_of(before.line, before.from_mm, before.to_mm, tree).left_mm;
  metrics.erased_wrong_lines = wrong;
}

}  // namespace felt
