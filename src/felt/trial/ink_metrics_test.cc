#include "felt/trial/ink_metrics.h"

#include <gtest/gtest.h>

#include <cmath>

namespace felt::ink_metrics_test {
namespace {

InkLine line_of(std::vector<Point> points, double width_mm = 1.0) {
  const std::size_t count = points.size();
  return {std::move(points), std::vector<double>(count, width_mm), false};
}

TEST(InkMetrics, InkIsClosedIfNoEndIsLoose) {
  TrialMetrics metrics;
  measure_closing({}, metrics);
  EXPECT_FALSE(metrics.is_closed);
  const InkLine open = line_of({{0, 0}, {10, 0}, {10, 10}});
  measure_closing({{open}}, metrics);
  EXPECT_EQ(metrics.is_closed, 0.0);
  measure_closing({{open, line_of({{10, 10}, {0, 0.005}})}}, metrics);
  EXPECT_EQ(metrics.is_closed, 1.0) << "two lines that meet at both ends";
  InkLine closed = line_of({{0, 0}, {10, 0}, {10, 10}, {0, 0}});
  closed.is_closed = true;
  measure_closing({{closed}}, metrics);
  EXPECT_EQ(metrics.is_closed, 1.0);
  measure_closing({{closed, open}}, metrics);
  EXPECT_EQ(metrics.is_closed, 0.0);
}

TEST(InkMetrics, TheWidthIsMeasuredBetweenTheEnds) {
  TrialMetrics metrics;
  measure_width({{line_of({{0, 0}, {9, 0}})}}, 2.0, metrics);
  EXPECT_FALSE(metrics.width_mean_mm) << "nothing is left between the ends";
  measure_width({{line_of({{0, 0}, {40, 0}}, 2.5)}}, 2.0, metrics);
  EXPECT_NEAR(*metrics.width_mean_mm, 2.5, 1e-12);
  EXPECT_NEAR(*metrics.width_err_mm, 0.5, 1e-12);
  EXPECT_NEAR(*metrics.width_cv, 0.0, 1e-12);
  // The ends do not count, and the width grows from 1 to 3 between them.
  const InkLine wedge{{{0, 0}, {5, 0}, {15, 0}, {20, 0}}, {9.0, 1.0, 3.0, 0.1}, false};
  measure_width({{wedge}}, 2.0, metrics);
  EXPECT_NEAR(*metrics.width_mean_mm, 2.0, 1e-12);
  EXPECT_NEAR(*metrics.width_err_mm, 0.5, 0.03);
  EXPECT_NEAR(*metrics.width_cv, 2.0 / std::sqrt(12.0) / 2.0, 0.03);
}

TEST(InkMetrics, ErasingIsMeasuredOnAllLines) {
  const ErasedPage page{.line = {{0, 0}, {40, 0}},
                        .from_mm = 10.0,
                        .to_mm = 30.0,
                        .others = {{{0, 5}, {40, 5}}, {{0, 9}, {40, 9}}}};
  TrialMetrics metrics;
  measure_erasing(page, {{line_of(page.line), line_of(page.others[0]), line_of(page.others[1])}},
                  metrics);
  EXPECT_NEAR(*metrics.erased_left_mm, 20.0, 1e-9);
  EXPECT_EQ(*metrics.erased_extra_mm, 0.0);
  EXPECT_EQ(*metrics.erased_wrong_lines, 0.0);
  // Erased from 8 to 29 mm, and 3 mm of one other line.
  measure_erasing(
      page,
      {{line_of({{8, 0}, {0, 0}}), line_of({{29, 0}, {40, 0}}), line_of({{0, 5}, {20, 5}}),
        line_of({{23, 5}, {40, 5}}), line_of(page.others[1])}},
      metrics);
  EXPECT_NEAR(*metrics.erased_left_mm, 1.0, 0.11);
  EXPECT_NEAR(*metrics.erased_extra_mm, 2.0 + 3.0, 0.21);
  EXPECT_EQ(*metrics.erased_wrong_lines, 1.0);
  measure_erasing(page, {}, metrics);
  EXPECT_NEAR(*metrics.erased_extra_mm, 20.0 + 80.0, 1e-9);
  EXPECT_EQ(*metrics.erased_wrong_lines, 2.0);
}

}  // namespace
}  // namespace felt::ink_metrics_test
