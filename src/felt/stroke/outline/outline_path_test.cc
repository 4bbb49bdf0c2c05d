#include "felt/stroke/outline/outline_path.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "felt/stroke/testing/ink_oracle.h"
#include "felt/stroke/testing/random_stroke.h"

namespace felt::outline_path_test {
namespace {

/// Returns the path as polygons, with its curves finely flattened.
Outline polygons_of(const OutlinePath& path) {
  constexpr int kSteps = 64;
  Outline out;
  const Point* p = path.points.data();
  for (const OutlinePath::Verb verb : path.verbs) {
    switch (verb) {
      case OutlinePath::Verb::kMove:
      case OutlinePath::Verb::kLine:
        out.points.push_back(*p++);
        break;
      case OutlinePath::Verb::kCubic: {
        const Cubic c{{out.points.back(), p[0], p[1], p[2]}};
        for (int i = 1; i <= kSteps; ++i) {
          out.points.push_back(evaluate(c, static_cast<double>(i) / kSteps));
        }
        p += 3;
        break;
      }
      case OutlinePath::Verb::kClose:
        out.ends.push_back(out.points.size());
        break;
    }
  }
  return out;
}

std::size_t curves_of(const OutlinePath& path) {
  return static_cast<std::size_t>(
      std::count(path.verbs.begin(), path.verbs.end(), OutlinePath::Verb::kCubic));
}

TEST(OutlinePath, IsTheInkOfRandomStrokes) {
  for (std::uint64_t seed = 0; seed < 250; ++seed) {
    SCOPED_TRACE(seed);
    const Stroke s = testing::random_stroke(seed);
    const OutlinePath path = outline_path(s, 0.005);
    const Outline outline = polygons_of(path);
    ASSERT_EQ(outline.contour_count(), s.closed() ? 2u : 1u);
    testing::expect_outline_is_the_ink(outline, s, 0.01, seed, 200);
    if (::testing::Test::HasFailure()) break;
  }
}

/// If the outline is rounded to 0.001 mm, as in files, it is within 0.01 mm (R53).
TEST(OutlinePath, R53_IsWithinAHundredthOfAMillimetre) {
  for (std::uint64_t seed = 250; seed < 450; ++seed) {
    SCOPED_TRACE(seed);
    const Stroke s = testing::random_stroke(seed);
    testing::expect_outline_is_the_ink(polygons_of(outline_path(s, 0.009)), s, 0.0075, seed, 200);
    if (::testing::Test::HasFailure()) break;
  }
}

/// If a line reverses and is wider at that end, both sides agree on which of them goes round the
/// end.
TEST(OutlinePath, ALineThatReversesKeepsItsEnd) {
  for (const std::uint64_t seed : {55U, 760U, 2167U, 2782U}) {
    SCOPED_TRACE(seed);
    const Stroke s = testing::random_stroke(seed);
    testing::expect_outline_is_the_ink(polygons_of(outline_path(s, 0.009)), s, 0.01, seed, 2000);
  }
}

/// Random strokes have many bends that are tighter than their half width.
TEST(OutlinePath, TightBendsTakeFewPoints) {
  std::size_t points = 0;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    points += outline_path(testing::random_stroke(seed), 0.009).points.size();
  }
  EXPECT_LT(points, 200U * 240U);
}

TEST(OutlinePath, EasyStrokesTakeFewCurves) {
  EXPECT_LE(curves_of(outline_path(testing::straight_stroke({0, 0}, {30, 5}, 0.3, 2.0), 0.005)),
            8u);
  const Stroke arch = Stroke::create({.points = {{0, 0}, {5, 8}, {15, 8}, {20, 0}},
                                      .joints = {},
                                      .closed = false,
                                      .widths = {{0.0, 0.4}, {1.0, 1.2}}})
                          .value();
  const OutlinePath path = outline_path(arch, 0.005);
  EXPECT_LE(curves_of(path), 16u);
  EXPECT_LT(10 * path.points.size(), 10 * outline_of(arch, 0.005).points.size());
}

TEST(OutlinePath, WidthThatJumpsOnTheSpot) {
  const Cubic c = straight({0, 0}, {10, 0});
  const double cut = 0.5, next = std::nextafter(cut, 1.0);
  const Stroke s = Stroke::create({.points = {c.p.begin(), c.p.end()},
                                   .joints = {},
                                   .closed = false,
                                   .widths = {{0, 0.4}, {cut, 0.4}, {next, 4.0}, {1, 4.0}}})
                       .value();
  testing::expect_outline_is_the_ink(polygons_of(outline_path(s, 0.005)), s, 0.01, 1, 400);
}

}  // namespace
}  // namespace felt::outline_path_test
