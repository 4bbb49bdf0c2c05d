#include "felt/io/svg/svg_path_parser.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "felt/io/svg/svg_length.h"

namespace felt::svg_path_parser_test {
namespace {

std::vector<SvgContour> path(std::string_view d) {
  const SvgPathData data = parse_svg_path(d, 1000);
  EXPECT_EQ(data.problem, "") << d;
  return data.contours;
}

std::vector<Point> ends(const SvgContour& c) {
  std::vector<Point> points;
  for (std::size_t i = 0; i < c.points.size(); i += 3) points.push_back(c.points[i]);
  return points;
}

using Points = std::vector<Point>;

TEST(SvgPathData, Lines) {
  const auto p = path("M1 2L3,4 h5v-6H0V1z");
  ASSERT_EQ(p.size(), 1U);
  EXPECT_TRUE(p[0].closed);
  EXPECT_EQ(ends(p[0]), (Points{{1, 2}, {3, 4}, {8, 4}, {8, -2}, {0, -2}, {0, 1}, {1, 2}}));
  EXPECT_EQ(p[0].points[1], lerp(Point{1, 2}, Point{3, 4}, 1.0 / 3.0));
}

TEST(SvgPathData, NumbersRunTogether) {
  EXPECT_EQ(ends(path("M.5.5-1-2 3e0.25+7,8")[0]), (Points{{.5, .5}, {-1, -2}, {3, .25}, {7, 8}}));
  EXPECT_EQ(ends(path("m1-1l1e2-1E-1")[0]), (Points{{1, -1}, {101, -1.1}}));
}

TEST(SvgPathData, MovesRepeatAsLines) {
  const auto p = path("m1 1 1 0m5 5 0 2");
  ASSERT_EQ(p.size(), 2U);
  EXPECT_EQ(ends(p[0]), (Points{{1, 1}, {2, 1}}));
  EXPECT_EQ(ends(p[1]), (Points{{7, 6}, {7, 8}}));
  EXPECT_TRUE(path("M 1 1 M 2 2").empty());
  EXPECT_EQ(path("M1 1h5zl1 1")[1].points[0], (Point{1, 1}));
}

TEST(SvgPathData, SmoothCurvesMirrorOnlyTheirKind) {
  const auto c = path("M0 0C0 1 2 1 2 0S4 -1 4 0")[0];
  EXPECT_EQ(c.points[4], (Point{2, -1}));
  EXPECT_EQ(path("M0 0Q1 1 2 0S4 -1 4 0")[0].points[4], (Point{2, 0}));
  const auto q = path("M0 0Q3 3 6 0T12 0")[0];
  EXPECT_EQ(q.points[1], (Point{2, 2}));
  EXPECT_NEAR(q.points[4].y, -2.0, 1e-12);
  EXPECT_EQ(path("M0 0C0 1 2 1 2 0T4 0")[0].points[4], (Point{2, 0}));
}

TEST(SvgPathData, ErrorsEndIt) {
  struct Case {
    const char* d;
    std::size_t segments;
    const char* problem;
  };
  for (const Case& c :
       {Case{"L1 1", 0, "is not M"}, Case{"M1 1 L2 2 L3 x", 1, "character 14"},
        Case{"M1 1 L2 2 3", 1, "a number is missing"}, Case{"M1 1h5 R3 3", 1, "no command"},
        Case{"M1 1A5 5 0 2 0 9 9", 0, "a number is missing"}, Case{"M1 1L1e10 1", 0, "beyond 1e9"},
        Case{"M1 1L1e400 1", 0, "number"}, Case{"M1 1 L inf nan", 0, "number"}}) {
    const SvgPathData data = parse_svg_path(c.d, 1000);
    std::size_t segments = 0;
    for (const SvgContour& contour : data.contours) segments += contour.segment_count();
    EXPECT_EQ(segments, c.segments) << c.d;
    EXPECT_NE(data.problem.find(c.problem), std::string::npos) << c.d << ": " << data.problem;
  }
  EXPECT_EQ(parse_svg_path("M1 1L1e9 1", 9).problem, "");
  EXPECT_EQ(parse_svg_path("M1 1L1e-400 1", 9).problem, "");
  EXPECT_EQ(parse_svg_path("M1 1L" + std::string(63, '1') + " 1", 9).problem.empty(), false);
  EXPECT_EQ(parse_svg_path("M1 1L0." + std::string(62, '1') + " 1", 9).problem, "");
  EXPECT_NE(parse_svg_path("M1 1L0." + std::string(63, '1') + " 1", 9).problem, "");
}

TEST(SvgPathData, NumberOfCurvesIsLimited) {
  std::string d = "M0 0";
  for (int i = 0; i < 100; ++i) d += "h1";
  EXPECT_EQ(parse_svg_path(d, 100).problem, "");
  EXPECT_EQ(parse_svg_path(d, 101).problem, "");
  const SvgPathData cut = parse_svg_path(d, 99);
  EXPECT_EQ(cut.contours[0].segment_count(), 99U);
  EXPECT_NE(cut.problem, "");
}

/// Points of an arc lie on an ellipse with the given axes and a centre that fits both ends. Large
/// and small arcs, and both directions, are distinguished.
TEST(SvgPathData, ArcsLieOnTheirEllipse) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  for (int i = 0; i < 2000; ++i) {
    const double rx = 1.0 + 20.0 * unit(random), ry = 1.0 + 20.0 * unit(random);
    const double turn = 360.0 * unit(random);
    const bool large = unit(random) < 0.5, sweep = unit(random) < 0.5;
    const Point from{20.0 * unit(random), 20.0 * unit(random)};
    const Point to{20.0 * unit(random), 20.0 * unit(random)};
    SvgPathBuilder builder(10);
    builder.move(from);
    builder.arc(rx, ry, turn, large, sweep, to);
    const SvgContour arc = builder.take().at(0);
    ASSERT_EQ(arc.points.front(), from);
    ASSERT_EQ(arc.points.back(), to);
    // In units of the ellipse, the arc is a part of a circle. Its radius is 1, or larger if the
    // radii were too small.
    const Affine round =
        then(rotation(-turn * 3.14159265358979323846 / 180.0), scaling(1.0 / rx, 1.0 / ry));
    std::vector<Point> on;
    double swept = 0.0;
    for (std::size_t k = 0; k < arc.segment_count(); ++k) {
      for (double t = 0.0; t < 1.0; t += 0.125) {
        on.push_back(apply(round, evaluate(arc.segment(k), t)));
      }
    }
    on.push_back(apply(round, to));
    const Point a = on.front(), b = on[on.size() / 2], c = on.back();
    const double chord = 0.5 * distance(a, c), radius = std::max(1.0, chord);
    // The centre has the distance `radius` from three points of the arc: intersect the bisectors.
    const double d = 2.0 * cross(b - a, c - a);
    if (std::fabs(d) < 1e-3) continue;
    const Vec bb = b - a, cc = c - a;
    const Point center{a.x + (cc.y * norm_squared(bb) - bb.y * norm_squared(cc)) / d,
                       a.y + (bb.x * norm_squared(cc) - cc.x * norm_squared(bb)) / d};
    for (std::size_t k = 0; k < on.size(); ++k) {
      EXPECT_NEAR(distance(center, on[k]), radius, 6e-4 * radius + 2e-4 / std::fabs(d)) << i;
      if (k > 0)
        swept += std::atan2(cross(on[k - 1] - center, on[k] - center),
                            dot(on[k - 1] - center, on[k] - center));
    }
    EXPECT_EQ(swept > 0.0, sweep) << i;
    if (chord < 0.99) {
      EXPECT_EQ(std::fabs(swept) > 3.14159265, large) << i;
    }
  }
}

/// Transforming a path point by point equals transforming its curves.
TEST(SvgPathData, TransformsCommute) {
  const Affine a = *svg_transform("rotate(30) translate(3 4)");
  const Affine b = then(*svg_transform("translate(3 4)"), *svg_transform("rotate(30)"));
  for (const SvgContour& c : path("M1 2C3 4 5 6 7 8A3 4 5 1 0 2 2Q1 1 9 9")) {
    for (std::size_t i = 0; i < c.segment_count(); ++i) {
      for (double t = 0.0; t <= 1.0; t += 0.25) {
        EXPECT_LT(
            distance(apply(a, evaluate(c.segment(i), t)), evaluate(apply(b, c.segment(i)), t)),
            1e-12);
      }
    }
  }
}

TEST(SvgTransform, ListsAndErrors) {
  EXPECT_EQ(svg_transform(""), Affine{});
  EXPECT_EQ(svg_transform("none"), Affine{});
  EXPECT_EQ(svg_transform("matrix(1 2,3 4-5-6)"), (Affine{1, 2, 3, 4, -5, -6}));
  EXPECT_EQ(svg_transform("translate(2)"), translation({2, 0}));
  EXPECT_EQ(svg_transform(" scale( 2 , 3 ),scale(2)"), scaling(4, 6));
  EXPECT_EQ(svg_transform("rotate(90)"), (Affine{0, 1, -1, 0, 0, 0}));
  EXPECT_EQ(svg_transform("rotate(-270deg)"), (Affine{0, 1, -1, 0, 0, 0}));
  EXPECT_EQ(svg_transform("rotate(180 5 5)"), (Affine{-1, 0, 0, -1, 10, 10}));
  for (const char* bad :
       {"rotate(20", "turn(3)", "scale()", "translate(1 2 3)", "matrix(1)", "rotate(1 2)",
        "scale(1e39) scale(1e39)", "translate(1x)", "scale(2) 3"}) {
    EXPECT_FALSE(svg_transform(bad)) << bad;
  }
}

TEST(SvgLength, Units) {
  SvgUnits units;
  units.view_width = 200.0;
  units.view_height = 50.0;
  units.font_size = 10.0;
  const auto x = [&](const char* text) { return svg_length(text, SvgAxis::kX, units); };
  EXPECT_EQ(x(" 12 "), 12.0);
  EXPECT_DOUBLE_EQ(*x("1in"), 96.0);
  EXPECT_DOUBLE_EQ(*x("25.4mm"), 96.0);
  EXPECT_DOUBLE_EQ(*x("3pt"), 4.0);
  EXPECT_DOUBLE_EQ(*x("2em"), 20.0);
  EXPECT_DOUBLE_EQ(*x("2ex"), 10.0);
  EXPECT_DOUBLE_EQ(*x("2rem"), 32.0);
  EXPECT_DOUBLE_EQ(*x("50%"), 100.0);
  EXPECT_EQ(svg_length("50%", SvgAxis::kY, units), 25.0);
  for (const char* bad : {"", "x", "1 2", "3zz", "1e400", "auto"}) EXPECT_FALSE(x(bad)) << bad;
  EXPECT_EQ(svg_paper_mm("210mm"), 210.0);
  EXPECT_EQ(svg_paper_mm("96"), 96 * kSvgMmPerPx);
  EXPECT_FALSE(svg_paper_mm("100%"));
}

}  // namespace
}  // namespace felt::svg_path_parser_test
