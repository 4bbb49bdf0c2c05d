// Checks lines with sharp ends and corners against the areas that SVG defines for them.
#include "felt/io/svg/svg_sharp_line.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "felt/io/svg/svg_import.h"
#include "felt/io/testing/test_drawings.h"
#include "felt/stroke/drawn_profile.h"
#include "felt/stroke/stroke.h"

namespace felt::svg_sharp_line_test {
namespace {

SvgContour path(const std::vector<Point>& corners, bool closed = false) {
  SvgPathBuilder builder(100);
  builder.move(corners.front());
  for (std::size_t i = 1; i < corners.size(); ++i) builder.line(corners[i]);
  if (closed) builder.close();
  return builder.take().front();
}

/// Returns how far p is outside the discs along the line, in mm; negative if it is inside.
double outside(const SvgSharpLine& line, Point p) {
  constexpr int kSteps = 200;
  double least = 1e9;
  for (std::size_t i = 0; i < line.contour.segment_count(); ++i) {
    const double from = line.widths[i].after_mm, to = line.widths[i + 1].before_mm;
    for (int k = 0; k <= kSteps; ++k) {
      const double t = static_cast<double>(k) / kSteps;
      const Point center = evaluate(line.contour.segment(i), t);
      least = std::min(least, distance(center, p) - 0.5 * (from + t * (to - from)));
    }
  }
  return least;
}

/// Expects that the ink covers exactly the points at which `depth` is positive: the depth in mm
/// below the edge of the area.
void expect_area(const SvgSharpLine& line, const std::function<double(Point)>& depth) {
  constexpr double kTolerance = 0.08;
  ASSERT_EQ(line.widths.size(), line.contour.segment_count() + 1);
  int inside = 0;
  for (double x = -5.0; x <= 25.0; x += 0.23) {
    for (double y = -5.0; y <= 25.0; y += 0.23) {
      const double d = depth({x, y});
      if (d > kTolerance) {
        EXPECT_LT(outside(line, {x, y}), 0.01) << x << " " << y;
        ++inside;
      } else if (d < -kTolerance) {
        EXPECT_GT(outside(line, {x, y}), -0.01) << x << " " << y;
      }
    }
  }
  EXPECT_GT(inside, 100);
}

double depth_in_box(Point p, const Rect& r) {
  return std::min({p.x - r.x0, r.x1 - p.x, p.y - r.y0, r.y1 - p.y});
}

TEST(SvgSharpLine, FlatAndSquareEnds) {
  const SvgContour line = path({{2.0, 10.0}, {20.0, 10.0}});
  expect_area(sharp_line(line, {4.0, SvgCap::kButt}), [](Point p) {
    return depth_in_box(p, {2.0, 8.0, 20.0, 12.0});
  });
  expect_area(sharp_line(line, {4.0, SvgCap::kSquare}), [](Point p) {
    return depth_in_box(p, {0.0, 8.0, 22.0, 12.0});
  });
}

// The drawn width is a smooth curve between breakpoints, which would make cones hollow.
TEST(SvgSharpLine, DrawnConesHaveStraightSides) {
  const Imported read =
      import_svg(
          "<svg xmlns='http://www.w3.org/2000/svg' width='60mm' height='60mm' viewBox='0 0 60 60'>"
          "<path d='M8 8H50V50H20' fill='none' stroke='#000' stroke-width='8'/></svg>")
          .value();
  const std::vector<Stroke> strokes = testing::strokes_in(read.drawing.document);
  ASSERT_EQ(strokes.size(), 1U);
  const Stroke& stroke = strokes[0];
  ASSERT_GT(stroke.widths().size(), 10U) << "cones at both ends and in both corners";
  for (double u = 0.0; u <= stroke.segment_count(); u += 0.01) {
    EXPECT_NEAR(drawn_width_mm(stroke, u), stroke.width_mm(u), 1e-3) << u;
  }
}

TEST(SvgSharpLine, LinesShorterThanTheirWidth) {
  const SvgSharpLine line = sharp_line(path({{2.0, 10.0}, {5.0, 10.0}}), {12.0});
  EXPECT_TRUE(line.is_exact);
  expect_area(line, [](Point p) { return depth_in_box(p, {2.0, 4.0, 5.0, 16.0}); });
  const SvgSharpLine dot = sharp_line(path({{9.0, 9.0}, {9.0, 9.0}}), {8.0, SvgCap::kSquare});
  expect_area(dot, [](Point p) { return depth_in_box(p, {5.0, 5.0, 13.0, 13.0}); });
}

TEST(SvgSharpLine, MitredAndCutCorners) {
  const SvgContour corner = path({{0.0, 2.0}, {18.0, 2.0}, {18.0, 20.0}});
  const auto mitred = [](Point p) {
    return std::max(depth_in_box(p, {0.0, 0.0, 20.0, 4.0}),
                    depth_in_box(p, {16.0, 0.0, 20.0, 20.0}));
  };
  expect_area(sharp_line(corner, {4.0}), mitred);
  const auto cut = [&](Point p) {
    return std::min(mitred(p), (p.y - p.x + 18.0) / std::sqrt(2.0));
  };
  expect_area(sharp_line(corner, {4.0, SvgCap::kButt, SvgJoin::kBevel}), cut);
  expect_area(sharp_line(corner, {4.0, SvgCap::kButt, SvgJoin::kMiter, 1.4}), cut);
}

TEST(SvgSharpLine, ClosedLinesHaveNoEnds) {
  const SvgContour square = path({{4.0, 4.0}, {16.0, 4.0}, {16.0, 16.0}, {4.0, 16.0}}, true);
  const auto frame = [](Point p) {
    return std::min(depth_in_box(p, {2.0, 2.0, 18.0, 18.0}),
                    -depth_in_box(p, {6.0, 6.0, 14.0, 14.0}));
  };
  for (const SvgJoin join : {SvgJoin::kMiter, SvgJoin::kBevel}) {
    const SvgSharpLine line = sharp_line(square, {4.0, SvgCap::kButt, join});
    EXPECT_TRUE(line.contour.closed);
    EXPECT_EQ(line.contour.points.front(), line.contour.points.back());
    expect_area(line, [&](Point p) {
      const double u = std::fabs(p.x - 10.0) + std::fabs(p.y - 10.0);
      return join == SvgJoin::kMiter ? frame(p) : std::min(frame(p), (14.0 - u) / std::sqrt(2.0));
    });
  }
}

TEST(SvgSharpLine, WhatDoesNotFitStaysRound) {
  const SvgSharpLine line = sharp_line(path({{0.0, 0.0}, {1.0, 0.0}, {1.0, 20.0}}), {4.0});
  EXPECT_FALSE(line.is_exact);
  const SvgSharpLine round = sharp_line(path({{0.0, 0.0}, {9.0, 0.0}, {9.0, 9.0}}),
                                        {4.0, SvgCap::kRound, SvgJoin::kRound});
  EXPECT_TRUE(round.is_exact);
  EXPECT_EQ(round.contour.segment_count(), 2U);
}

}  // namespace
}  // namespace felt::svg_sharp_line_test
