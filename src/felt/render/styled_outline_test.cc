#include "felt/render/styled_outline.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "felt/render/style_layout.h"
#include "felt/stroke/testing/ink_oracle.h"
#include "felt/stroke/testing/random_stroke.h"

namespace felt::styled_outline_test {
namespace {

using testing::winding;

constexpr double kToleranceMm = 0.01;

StrokeStyle style_of(MediumStyle how) {
  StrokeStyle style{std::move(how), {}};
  style.shape = read_style_shape(style.how.shape).value();
  return style;
}

/// Returns a style of every kind and some with arrow heads, with values that depend on the seed.
std::vector<StrokeStyle> random_styles(std::uint64_t seed) {
  testing::RandomStroke random(seed);
  std::vector<StrokeStyle> styles;
  for (std::size_t kind = 0; kind < kStyleKinds.size(); ++kind) {
    MediumStyle how;
    how.kind = static_cast<StyleKind>(kind);
    how.length = random.uniform(0.2, 6.0);
    how.gap = random.uniform(0.0, 3.0);
    how.thin = random.uniform(0.05, 1.0);
    how.arrows = static_cast<StyleArrows>(random.pick(kind == 0 ? 1 : 0, 3));
    how.arrow_length = random.uniform(0.5, 4.0);
    how.angle_deg = random.uniform(-90.0, 90.0);
    how.spacing_mm = random.uniform(0.3, 4.0);
    how.shape =
        random.chance(0.5) ? "M0 .5L.2 -.5 1 -.2 .5 0zM.2 .1h.5v.1z" : std::string(kLensShape);
    styles.push_back(style_of(how));
  }
  return styles;
}

StyledInk ink_of(const Stroke& stroke, const StrokeStyle& style) {
  StrokeStyler styler;
  return styler.ink(stroke, style, kToleranceMm);
}

/// Returns the ink without its hatching.
Outline unhatched(const StyledInk& ink) {
  Outline outline = ink.outline;
  const std::size_t lines = ink.hatching.size() / 2;
  outline.ends.resize(outline.ends.size() - lines);
  outline.points.resize(outline.ends.empty() ? 0 : outline.ends.back());
  return outline;
}

TEST(StyledOutline, StaysWithinThePlainInkOfAnyStroke) {
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    SCOPED_TRACE(seed);
    const Stroke stroke = testing::random_stroke(seed);
    std::vector<Dab> dabs;
    flatten(stroke, 0.1 * kToleranceMm, dabs);
    for (const StrokeStyle& style : random_styles(seed)) {
      SCOPED_TRACE(kStyleKinds[static_cast<std::size_t>(style.how.kind)]);
      const StyledInk ink = ink_of(stroke, style);
      ASSERT_FALSE(ink.outline.points.empty());
      ASSERT_LE(ink.outline.points.size(), StrokeStyler::kMaxPoints);
      const Outline outline = unhatched(ink);
      for (std::size_t i = 0; i < outline.points.size(); i += 1 + outline.points.size() / 150) {
        ASSERT_LE(testing::distance_outside(dabs, outline.points[i]), 2.0 * kToleranceMm);
      }
      for (const Point p : ink.outline.points) {
        ASSERT_TRUE(stroke.bounds().inflated(2.0 * kToleranceMm).contains(p));
      }
    }
  }
}

TEST(StyledOutline, IsTheSameFromAnyStyler) {
  StrokeStyler styler;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const Stroke stroke = testing::random_stroke(seed);
    for (const StrokeStyle& style : random_styles(seed)) {
      const Outline first = styler.ink(stroke, style, kToleranceMm).outline;
      const std::size_t made = styler.made_count();
      EXPECT_EQ(styler.ink(stroke, style, kToleranceMm).outline.points, first.points);
      EXPECT_EQ(styler.made_count(), made) << "the ink is kept";
      EXPECT_EQ(ink_of(stroke, style).outline.points, first.points) << seed;
      EXPECT_EQ(ink_of(stroke, style).outline.ends, first.ends) << seed;
    }
  }
}

double area_of(std::span<const Point> contour) {
  double sum = 0.0;
  for (std::size_t i = 0; i < contour.size(); ++i) {
    sum += cross(contour[i] - Point{}, contour[(i + 1) % contour.size()] - Point{});
  }
  return 0.5 * sum;
}

Rect box_of(std::span<const Point> contour) {
  Rect box;
  for (const Point p : contour) box.extend(p);
  return box;
}

TEST(StyledOutline, TurnsWithTheStroke) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    StrokeData data = testing::random_stroke(seed).data();
    const Stroke stroke = Stroke::create(data).value();
    for (Point& p : data.points) p = {-p.y, p.x};
    const Stroke turned = Stroke::create(data).value();
    for (const StrokeStyle& style : random_styles(seed)) {
      if (style.how.kind == StyleKind::kHatch) continue;  // fixed on the page
      const Outline a = ink_of(stroke, style).outline, b = ink_of(turned, style).outline;
      ASSERT_EQ(a.ends, b.ends) << seed;
      for (std::size_t k = 0; k < a.contour_count(); ++k) {
        const Rect box = box_of(a.contour(k)), other = box_of(b.contour(k));
        ASSERT_NEAR(area_of(a.contour(k)), area_of(b.contour(k)), 1e-6) << seed;
        ASSERT_NEAR(box.x0, other.y0, kToleranceMm) << seed;
        ASSERT_NEAR(-box.y0, other.x1, kToleranceMm) << seed;
      }
    }
  }
}

/// A straight line from (0, 0) to (40, 0), 2 mm wide.
Stroke straight() {
  return testing::straight_stroke({0, 0}, {40, 0}, 2.0, 2.0);
}

bool is_inked(const Outline& outline, Point p) {
  return winding(outline, p) != 0;
}

TEST(StyledOutline, DashesFillTheLineAsAWhole) {
  const Outline outline =
      ink_of(straight(), style_of({.kind = StyleKind::kDashes, .length = 3.0, .gap = 1.5})).outline;
  // 20 widths and two half caps are 21 widths: 5 dashes and 4 gaps need exactly these.
  ASSERT_EQ(outline.contour_count(), 5u);
  for (std::size_t k = 0; k < 5; ++k) {
    const auto begin = -1.0 + 9.0 * static_cast<double>(k);
    const auto contour = outline.contour(k);
    const auto [low, high] = std::minmax_element(contour.begin(), contour.end(),
                                                 [](Point a, Point b) { return a.x < b.x; });
    EXPECT_NEAR(low->x, begin, 1e-9);
    EXPECT_NEAR(high->x, begin + 6.0, 1e-9);
  }
}

TEST(StyledOutline, DashesScaleToFit) {
  for (const double length : {0.3, 1.0, 2.0, 3.1, 7.0, 30.0}) {
    for (const double gap : {0.0, 0.4, 1.0, 5.0}) {
      const Outline outline =
          ink_of(straight(), style_of({.kind = StyleKind::kDashes, .length = length, .gap = gap}))
              .outline;
      Rect box;
      for (const Point p : outline.points) box.extend(p);
      EXPECT_NEAR(box.x0, -1.0, 0.6) << length << ' ' << gap;
      EXPECT_NEAR(box.x1, 41.0, 0.6) << length << ' ' << gap;
      EXPECT_NEAR(box.x0 + box.x1, 40.0, 1e-6) << "symmetric";
    }
  }
}

/// A closed square with corners at (0, 0) and (20, 20), 1 mm wide.
Stroke square() {
  StrokeData d;
  const std::array<Point, 5> p{{{0, 0}, {20, 0}, {20, 20}, {0, 20}, {0, 0}}};
  d.points.push_back(p[0]);
  for (std::size_t i = 0; i < 4; ++i) {
    d.points.insert(d.points.end(),
                    {lerp(p[i], p[i + 1], 1.0 / 3.0), lerp(p[i], p[i + 1], 2.0 / 3.0), p[i + 1]});
  }
  d.joints.assign(4, JointKind::kCorner);
  d.closed = true;
  d.widths = {{0.0, 1.0}, {4.0, 1.0}};
  return Stroke::create(std::move(d)).value();
}

TEST(StyledOutline, DashesBendAroundCorners) {
  const Outline outline =
      ink_of(square(), style_of({.kind = StyleKind::kDashes, .length = 3.0, .gap = 2.0})).outline;
  EXPECT_EQ(outline.contour_count(), 16u) << "20 / (3 + 2) on each side";
  for (const Point corner : {Point{0, 0}, Point{20, 0}, Point{20, 20}, Point{0, 20}}) {
    EXPECT_TRUE(is_inked(outline, corner));
    const Vec in{corner.x > 0 ? -1.0 : 1.0, corner.y > 0 ? -1.0 : 1.0};
    for (const double way : {0.9, 1.2, 1.7, 3.2}) {
      EXPECT_EQ(is_inked(outline, corner + Vec{in.x * way, 0.0}), way < 1.5) << way;
      EXPECT_EQ(is_inked(outline, corner + Vec{0.0, in.y * way}), way < 1.5) << way;
    }
  }
}

/// A hand that moves in jerks makes many small corners. They do not change the rhythm.
TEST(StyledOutline, SmallCornersDoNotDivideALine) {
  StrokeData d;
  d.points.push_back({0, 0});
  for (int i = 1; i <= 40; ++i) {
    const Point from = d.points.back(), to{1.0 * i, i % 2 == 0 ? 0.0 : 0.2};
    d.points.insert(d.points.end(), {lerp(from, to, 1.0 / 3.0), lerp(from, to, 2.0 / 3.0), to});
  }
  d.joints.assign(39, JointKind::kCorner);
  d.widths = {{0.0, 2.0}, {40.0, 2.0}};
  const StrokeStyle style = style_of({.kind = StyleKind::kDashes, .length = 3.0, .gap = 1.5});
  EXPECT_EQ(ink_of(Stroke::create(d).value(), style).outline.contour_count(), 5u);
}

/// The sides of a zigzag are too short for a gap between two corners.
TEST(StyledOutline, R57_AZigzagOfShortSidesStaysDashed) {
  for (const double side : {0.8, 1.5, 3.0, 4.0}) {
    StrokeData d;
    d.points.push_back({0, 0});
    for (int i = 1; i <= 40; ++i) {
      const Point from = d.points.back(), to{side * i, i % 2 == 0 ? 0.0 : side};
      d.points.insert(d.points.end(), {lerp(from, to, 1.0 / 3.0), lerp(from, to, 2.0 / 3.0), to});
    }
    d.joints.assign(39, JointKind::kCorner);
    d.widths = {{0.0, 1.0}, {40.0, 1.0}};
    const StrokeStyle style = style_of({.kind = StyleKind::kDashes, .length = 3.0, .gap = 2.0});
    const double widths = 40.0 * std::sqrt(2.0) * side;
    EXPECT_GE(static_cast<double>(ink_of(Stroke::create(d).value(), style).outline.contour_count()),
              widths / 5.0 / 1.7)
        << side;
  }
}

TEST(StyledOutline, RailsMeetAtCorners) {
  const Outline outline =
      ink_of(square(), style_of({.kind = StyleKind::kDouble, .thin = 0.2})).outline;
  for (const double x : {0.5, 3.0, 10.0, 19.5}) {
    EXPECT_FALSE(is_inked(outline, {x, 0.0})) << x;
    EXPECT_TRUE(is_inked(outline, {x, -0.4})) << x;
    EXPECT_EQ(is_inked(outline, {x, 0.4}), x > 0.45) << x;
  }
  EXPECT_TRUE(is_inked(outline, {0.4, 0.4}));
  EXPECT_TRUE(is_inked(outline, {19.6, 0.4}));
  for (const double beyond : {-0.1, 0.1, 0.2}) {  // no rail crosses another
    EXPECT_FALSE(is_inked(outline, {20.0 + beyond, 0.4 - beyond * 0.1})) << beyond;
  }
  EXPECT_FALSE(is_inked(outline, {10.0, 10.0}));
}

TEST(StyledOutline, RailsHaveNoLoopsInTightBends) {
  // A bend of radius 1 mm in a line that is 6 mm wide.
  const Stroke bend =
      Stroke::create({.points = {{0, 0}, {10, 0}, {19, 0}, {20, 1}, {21, 2}, {20, 10}, {20, 20}},
                      .joints = {JointKind::kSmooth},
                      .closed = false,
                      .widths = {{0.0, 6.0}, {2.0, 6.0}}})
          .value();
  const Outline outline = ink_of(bend, style_of({.kind = StyleKind::kDouble, .thin = 0.1})).outline;
  for (const Point p : {Point{10, 2.7}, Point{10, -2.7}, Point{17.6, 15.0}}) {
    EXPECT_TRUE(is_inked(outline, p)) << p.x << ' ' << p.y;
  }
  for (double x = 18.5; x < 23.0; x += 0.25) EXPECT_FALSE(is_inked(outline, {x, 2.7})) << x;
}

TEST(StyledOutline, RepeatsAndStretchesItsShape) {
  const MediumStyle repeat{.kind = StyleKind::kRepeat, .length = 2.0, .gap = 0.5};
  EXPECT_EQ(ink_of(straight(), style_of(repeat)).outline.contour_count(), 8u);
  const Outline leaf = ink_of(straight(), style_of({.kind = StyleKind::kStretch})).outline;
  ASSERT_EQ(leaf.contour_count(), 1u);
  EXPECT_TRUE(is_inked(leaf, {20.0, 0.74}));
  EXPECT_FALSE(is_inked(leaf, {20.0, 0.76}));
  EXPECT_FALSE(is_inked(leaf, {1.0, 0.3}));
}

/// The seam is in the middle of a side, so that the last shape goes across it.
TEST(StyledOutline, ShapesGoAcrossTheSeamOfAClosedLine) {
  StrokeData d = square().data();
  std::rotate(d.points.begin(), d.points.begin() + 3, d.points.end() - 1);
  d.points.back() = d.points.front();
  const Stroke rotated = Stroke::create(d).value();
  StrokeData cut = square().data();
  const Cubic top = square().segment(0);
  const auto [left, right] = split(top, 0.5);
  cut.points.assign(right.p.begin(), right.p.end());
  cut.points.insert(cut.points.end(), d.points.begin() + 1, d.points.begin() + 10);
  cut.points.insert(cut.points.end(), left.p.begin() + 1, left.p.end());
  cut.points.back() = cut.points.front();
  cut.joints = {JointKind::kCorner, JointKind::kCorner, JointKind::kCorner, JointKind::kCorner,
                JointKind::kSmooth};
  cut.widths = {{0.0, 1.0}, {5.0, 1.0}};
  const Stroke with_seam = Stroke::create(cut).value();
  for (const StyleKind kind : {StyleKind::kDashes, StyleKind::kRepeat, StyleKind::kDouble}) {
    const StrokeStyle style =
        style_of({.kind = kind, .length = 3.0, .gap = 2.0, .thin = 0.4, .shape = "M0 -.5H1V.5H0Z"});
    const Outline a = ink_of(rotated, style).outline, b = ink_of(with_seam, style).outline;
    int inked = 0;
    for (double x = -0.95; x < 21.0; x += 0.1) {
      for (const double y : {-0.31, 0.02, 0.27}) {
        EXPECT_EQ(is_inked(a, {x, y}), is_inked(b, {x, y})) << x << ' ' << y;
        inked += is_inked(a, {x, y}) ? 1 : 0;
      }
    }
    EXPECT_GT(inked, 50);
  }
}

TEST(StyledOutline, HolesOfShapesStayOpenWhereverTheyPoint) {
  const std::string out = "M0 -.5H1V.5H0Z", hole = "M.2 -.2V.2H.8V-.2Z";
  for (const std::string& shape : {out + hole, hole + out}) {
    const Outline outline =
        ink_of(straight(), style_of({.kind = StyleKind::kStretch, .shape = shape})).outline;
    EXPECT_FALSE(is_inked(outline, {20.0, 0.0}));
    EXPECT_TRUE(is_inked(outline, {20.0, 0.8}));
    EXPECT_TRUE(is_inked(outline, {3.0, 0.0}));
  }
}

TEST(StyledOutline, ArrowHeadsEndWhereTheLineEnds) {
  const MediumStyle how{.thin = 0.2, .arrows = StyleArrows::kBoth, .arrow_length = 2.0};
  const Outline outline = ink_of(straight(), style_of(how)).outline;
  Rect box;
  for (const Point p : outline.points) box.extend(p);
  EXPECT_NEAR(box.x0, 0.0, 1e-9);
  EXPECT_NEAR(box.x1, 40.0, 1e-9);
  EXPECT_NEAR(box.y1, 1.0, 1e-9);
  EXPECT_TRUE(is_inked(outline, {20.0, 0.15}));
  EXPECT_FALSE(is_inked(outline, {20.0, 0.25}));
  EXPECT_TRUE(is_inked(outline, {37.0, 0.6}));
  EXPECT_TRUE(is_inked(outline, {3.0, 0.6}));
  EXPECT_FALSE(is_inked(outline, {35.5, 0.6}));
  EXPECT_FALSE(is_inked(outline, {39.0, 0.6}));
}

TEST(StyledOutline, HatchingFillsTheInsideByEvenOdd) {
  const StrokeStyle style =
      style_of({.kind = StyleKind::kHatch, .thin = 0.5, .angle_deg = 0.0, .spacing_mm = 2.0});
  const StyledInk ink = ink_of(square(), style);
  EXPECT_EQ(ink.hatching.size(), 2u * 10u) << "lines 1, 3, ... 19";
  EXPECT_TRUE(is_inked(ink.outline, {10.0, 5.2}));
  EXPECT_FALSE(is_inked(ink.outline, {10.0, 5.3}));
  EXPECT_FALSE(is_inked(ink.outline, {21.0, 5.0}));
  StrokeData open = square().data();
  open.closed = false;
  open.joints.pop_back();
  EXPECT_EQ(ink_of(Stroke::create(open).value(), style).hatching.size(), 20u) << "the ends meet";
  open.points.back().y += 7.0;  // of 73 mm
  EXPECT_EQ(ink_of(Stroke::create(open).value(), style).hatching.size(), 20u);
  open.points.back().y += 1.0;  // of 72 mm
  EXPECT_TRUE(ink_of(Stroke::create(open).value(), style).hatching.empty());
}

/// Who moves a shape expects its hatching to move with it.
TEST(StyledOutline, R57_HatchingMovesWithItsLine) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    StrokeData data = testing::random_stroke(seed).data();
    const Stroke stroke = Stroke::create(data).value();
    const Vec move{13.7, -4.1};
    for (Point& p : data.points) p += move;
    const Stroke moved = Stroke::create(data).value();
    const StrokeStyle style =
        style_of({.kind = StyleKind::kHatch, .angle_deg = 20.0, .spacing_mm = 0.7});
    const std::vector<Dab> a = ink_of(stroke, style).hatching, b = ink_of(moved, style).hatching;
    ASSERT_EQ(a.size(), b.size()) << seed;
    for (std::size_t i = 0; i < a.size(); ++i) {
      ASSERT_LE(distance(a[i].center + move, b[i].center), 1e-6) << seed;
    }
  }
}

TEST(StyledOutline, HatchingIsNoWiderThanItsLine) {
  // A ring that is 0.1 mm wide on one side and 8 mm on the other.
  constexpr double k = 20.0 * 0.5522847498;
  StrokeData d;
  d.points = {{20, 0},   {20, k},   {k, 20},  {0, 20},  {-k, 20}, {-20, k}, {-20, 0},
              {-20, -k}, {-k, -20}, {0, -20}, {k, -20}, {20, -k}, {20, 0}};
  d.joints.assign(4, JointKind::kSmooth);
  d.closed = true;
  d.widths = {{0.0, 0.1}, {2.0, 8.0}, {4.0, 0.1}};
  const Stroke ring = Stroke::create(d).value();
  for (const double angle : {0.0, 45.0, 90.0}) {
    const StyledInk ink =
        ink_of(ring, style_of({.kind = StyleKind::kHatch, .angle_deg = angle, .spacing_mm = 1.0}));
    EXPECT_FALSE(ink.hatching.empty());
    for (const Point p : ink.outline.points) {
      ASSERT_TRUE(ring.bounds().inflated(2.0 * kToleranceMm).contains(p)) << p.x << ' ' << p.y;
    }
  }
}

/// The ends of a spiral are near to each other in comparison with its length.
TEST(StyledOutline, SpiralsAndWavesAreNotClosed) {
  StrokeData spiral, wave;
  for (int i = 0; i <= 120; ++i) {
    const double angle = 0.3 * i, r = 1.0 + 0.2 * i;
    for (auto [d, to] : {std::pair{&spiral, Point{r * std::cos(angle), r * std::sin(angle)}},
                         std::pair{&wave, Point{0.3 * i, i % 2 == 0 ? 0.0 : 20.0}}}) {
      if (i == 0) {
        d->points.push_back(to);
        continue;
      }
      const Point from = d->points.back();
      d->points.insert(d->points.end(), {lerp(from, to, 1.0 / 3.0), lerp(from, to, 2.0 / 3.0), to});
    }
  }
  for (StrokeData* d : {&spiral, &wave}) {
    d->joints.assign(119, JointKind::kCorner);
    d->widths = {{0.0, 1.0}, {120.0, 1.0}};
    const Stroke stroke = Stroke::create(*d).value();
    EXPECT_TRUE(ink_of(stroke, style_of({.kind = StyleKind::kHatch})).hatching.empty());
  }
}

TEST(StyledOutline, HatchingCoversItsShareOfAnyClosedStroke) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const Stroke stroke = testing::random_stroke(seed);
    if (!stroke.closed()) continue;
    std::vector<Dab> dabs;
    flatten(stroke, 0.001, dabs);
    Outline inside;  // of the centre line
    for (const Dab& dab : dabs) inside.points.push_back(dab.center);
    inside.ends = {inside.points.size()};
    const StyledInk ink =
        ink_of(stroke, style_of({.kind = StyleKind::kHatch, .angle_deg = 30.0, .spacing_mm = 0.5}));
    for (std::size_t i = 0; i + 1 < ink.hatching.size(); i += 2) {
      const Point middle = lerp(ink.hatching[i].center, ink.hatching[i + 1].center, 0.5);
      if (distance(ink.hatching[i].center, ink.hatching[i + 1].center) < 0.05) continue;
      int crossings = 0;  // to the right of the middle
      for (std::size_t k = 0; k < inside.points.size(); ++k) {
        const Point a = inside.points[k], b = inside.points[(k + 1) % inside.points.size()];
        if ((a.y > middle.y) == (b.y > middle.y)) continue;
        crossings += a.x + (middle.y - a.y) / (b.y - a.y) * (b.x - a.x) > middle.x ? 1 : 0;
      }
      EXPECT_EQ(crossings % 2, 1) << "seed " << seed << ", line " << i / 2;
    }
  }
}

TEST(StyledOutline, WidthScalesTheStyle) {
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    StrokeData data = testing::random_stroke(seed).data();
    const Stroke stroke = Stroke::create(data).value();
    for (Point& p : data.points) p = {2.0 * p.x, 2.0 * p.y};
    for (WidthKnot& k : data.widths) k.width_mm *= 2.0;
    const Stroke large = Stroke::create(data).value();
    StrokeStyler styler;
    for (const StrokeStyle& style : random_styles(seed)) {
      if (style.how.kind == StyleKind::kHatch) continue;
      const Outline a = ink_of(stroke, style).outline;
      constexpr double kTwice = 2.0 * kToleranceMm;
      const Outline& b = styler.ink(large, style, kTwice).outline;
      ASSERT_EQ(a.ends, b.ends) << seed;
      for (std::size_t i = 0; i < a.points.size(); ++i) {
        ASSERT_LE(distance({2.0 * a.points[i].x, 2.0 * a.points[i].y}, b.points[i]), 1e-6) << seed;
      }
    }
  }
}

/// Dashes that moved with each zoom step would flicker, and a file would differ from the screen.
TEST(StyledOutline, R57_TheLayoutDoesNotDependOnTheTolerance) {
  StrokeStyler styler;
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    const Stroke stroke = testing::random_stroke(seed);
    for (const StyleKind kind : {StyleKind::kDashes, StyleKind::kRepeat}) {
      const StrokeStyle style = style_of({.kind = kind, .length = 0.7, .gap = 0.3});
      const std::size_t count = styler.ink(stroke, style, kToleranceMm).outline.contour_count();
      for (const double tolerance_mm : {0.001, 0.05, 0.2}) {
        EXPECT_EQ(styler.ink(stroke, style, tolerance_mm).outline.contour_count(), count)
            << seed << ' ' << tolerance_mm;
      }
    }
  }
}

TEST(StyledOutline, DotsHaveNoStyle) {
  const Stroke dot = testing::straight_stroke({0, 0}, {0.9, 0}, 2.0, 2.0);
  for (const StrokeStyle& style : random_styles(1)) {
    EXPECT_EQ(ink_of(dot, style).outline.points, outline_of(dot, kToleranceMm).points);
  }
}

TEST(StyledOutline, LongPatternsAreBounded) {
  const Stroke thread = testing::straight_stroke({0, 0}, {100'000, 0}, 0.05, 0.05);
  for (const StyleKind kind : {StyleKind::kDashes, StyleKind::kDouble, StyleKind::kRepeat}) {
    const StyledInk ink = ink_of(thread, style_of({.kind = kind, .length = 0.2, .gap = 0.0}));
    EXPECT_LE(ink.outline.points.size(), StrokeStyler::kMaxPoints);
    Rect box;
    for (const Point p : ink.outline.points) box.extend(p);
    EXPECT_NEAR(box.width(), 100'000.0, 10.0) << "the whole line has ink";
  }
}

/// All repeats together have too many points for the limit, so there are fewer.
TEST(StyledOutline, LargeRepeatsFillTheWholeLine) {
  const Stroke line = testing::straight_stroke({0, 0}, {100'000, 0}, 20.0, 20.0);
  StrokeStyler styler;
  const StyledInk& ink =
      styler.ink(line, style_of({.kind = StyleKind::kRepeat, .length = 0.2, .gap = 0.0}), 1e-5);
  Rect box;
  for (const Point p : ink.outline.points) box.extend(p);
  EXPECT_NEAR(box.width(), 100'000.0, 1.0);
}

TEST(StyledPath, IsTheOutlineAndThePlainOneWithoutAStyle) {
  const Stroke stroke = testing::random_stroke(5);
  EXPECT_EQ(styled_path(stroke, nullptr, 0.01).points, outline_path(stroke, 0.01).points);
  const StrokeStyle dashes = style_of({.kind = StyleKind::kDashes});
  const Outline outline = ink_of(stroke, dashes).outline;
  const OutlinePath path = styled_path(stroke, &dashes, kToleranceMm);
  EXPECT_EQ(path.points, outline.points);
  EXPECT_EQ(std::count(path.verbs.begin(), path.verbs.end(), OutlinePath::Verb::kClose),
            static_cast<std::ptrdiff_t>(outline.contour_count()));
}

}  // namespace
}  // namespace felt::styled_outline_test
