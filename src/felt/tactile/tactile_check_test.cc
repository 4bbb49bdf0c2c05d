#include "felt/tactile/tactile_check.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "felt/document/edit_builder.h"
#include "felt/geometry/affine.h"
#include "felt/stroke/testing/random_stroke.h"
#include "felt/tactile/seen_ink.h"

namespace felt::tactile_check_test {
namespace {

using enum TactileRule;

/// A drawing that is made by hand.
class Drawn {
 public:
  /// Adds straight lines through points; closed if the last point repeats the first.
  Drawn& line(const std::vector<Point>& points, double width_mm = 1.0) {
    StrokeData data;
    data.closed = points.size() > 3 && points.front() == points.back();
    data.points = {points.front()};
    for (std::size_t i = 1; i < points.size(); ++i) {
      const Cubic c = straight(points[i - 1], points[i]);
      data.points.insert(data.points.end(), {c.p[1], c.p[2], points[i]});
    }
    data.joints.assign(points.size() - (data.closed ? 1 : 2), JointKind::kCorner);
    return add(std::move(data), width_mm);
  }
  /// Adds straight lines through points with trips into the corners of flat ends and into pointed
  /// corners, as files with such lines give them (docs/formats/svg.md). Closed as in line().
  Drawn& sharp_line(const std::vector<Point>& points, double width_mm) {
    constexpr double kThin = 0.05;
    const double r = 0.5 * width_mm;
    std::vector<Point> path;
    std::vector<WidthKnot> widths;
    const auto go = [&](Point p, double width) {
      widths.push_back({static_cast<double>(path.size()), width});
      path.push_back(p);
    };
    const auto trip = [&](Point tip) {
      const Point from = path.back();
      go(lerp(from, tip, 1.0 - kThin / width_mm), kThin);
      go(from, width_mm);
    };
    const bool closed = points.size() > 3 && points.front() == points.back();
    const std::size_t n = points.size();
    for (std::size_t i = 0; i < n; ++i) {
      const Vec in = normalized(i > 0 ? points[i] - points[i - 1] : points[1] - points[0]);
      const Point beyond = closed ? points[1] : points[i] + in;
      const Vec out = normalized((i + 1 < n ? points[i + 1] : beyond) - points[i]);
      if (!closed && (i == 0 || i + 1 == n)) {
        go(points[i] + (i == 0 ? r : -r) * in, width_mm);
        trip(points[i] + r * perp(in));
        trip(points[i] - r * perp(in));
        continue;
      }
      go(points[i], width_mm);
      const double half = 0.5 * std::acos(dot(in, out));
      if (i > 0) trip(points[i] + r / std::cos(half) * normalized(in - out));
    }
    StrokeData data;
    data.closed = closed;
    data.points = {path.front()};
    for (std::size_t i = 1; i < path.size(); ++i) {
      const Cubic c = straight(path[i - 1], path[i]);
      data.points.insert(data.points.end(), {c.p[1], c.p[2], path[i]});
    }
    data.joints.assign(path.size() - (closed ? 1 : 2), JointKind::kCorner);
    data.widths = std::move(widths);
    return add(std::move(data));
  }
  /// Adds four arcs of 90 degrees; the error of the radius is 0.03 %.
  Drawn& circle(Point center, double radius_mm, double width_mm = 1.0) {
    const double k = 0.5522847498 * radius_mm, r = radius_mm;
    StrokeData data;
    data.closed = true;
    for (const Vec v :
         {Vec{r, 0}, Vec{r, k}, Vec{k, r}, Vec{0, r}, Vec{-k, r}, Vec{-r, k}, Vec{-r, 0},
          Vec{-r, -k}, Vec{-k, -r}, Vec{0, -r}, Vec{k, -r}, Vec{r, -k}, Vec{r, 0}}) {
      data.points.push_back(center + v);
    }
    data.joints.assign(4, JointKind::kSmooth);
    return add(std::move(data), width_mm);
  }
  Drawn& fill(const std::vector<Point>& points, Rgba color = {0, 0, 0, 255}) {
    FillLoop loop{{points.front()}, {}};
    for (std::size_t i = 1; i <= points.size(); ++i) {
      const Point to = points[i % points.size()];
      loop.points.insert(loop.points.end(), {loop.points.back(), to, to});
    }
    EditBuilder builder(document_);
    builder.add_fill({1}, std::make_shared<const Fill>(Fill{{loop}, color, 0.0}));
    EXPECT_TRUE(document_.apply(std::move(builder).build("Fill")));
    return *this;
  }
  [[nodiscard]] const Document& document() const noexcept { return document_; }

 private:
  Drawn& add(StrokeData data, double width_mm) {
    const double end = static_cast<double>(data.points.size() / 3);
    data.widths = {{.u = 0.0, .width_mm = width_mm}, {.u = end, .width_mm = width_mm}};
    return add(std::move(data));
  }
  Drawn& add(StrokeData data) {
    Result<Stroke> stroke = Stroke::create(std::move(data));
    EXPECT_TRUE(stroke) << stroke.error().message;
    EditBuilder builder(document_);
    builder.add({1}, std::make_shared<const Stroke>(*std::move(stroke)));
    EXPECT_TRUE(document_.apply(std::move(builder).build("Draw")));
    return *this;
  }

  Document document_;
};

/// Two lines that leave (20, 20) at an angle.
Drawn wedge(double degrees, bool as_one_line) {
  const double a = degrees * std::numbers::pi / 180.0;
  const Point apex{20, 20}, right{120, 20}, up{20 + 100 * std::cos(a), 20 + 100 * std::sin(a)};
  if (as_one_line) return Drawn().line({right, apex, up});
  return Drawn().line({apex, right}).line({apex, up});
}

Drawn hatching(int lines, double pitch_mm) {
  Drawn drawn;
  for (int i = 0; i < lines; ++i) drawn.line({{20, 20 + i * pitch_mm}, {80, 20 + i * pitch_mm}});
  return drawn;
}

Drawn widths(int count) {
  Drawn drawn;
  for (int i = 0; i < count; ++i) {
    drawn.line({{20, 20.0 + 20 * i}, {80, 20.0 + 20 * i}}, 0.5 + 0.6 * i);
  }
  return drawn;
}

std::vector<Point> rectangle(Point at, double width, double height) {
  return {at, at + Vec{width, 0}, at + Vec{width, height}, at + Vec{0, height}, at};
}

struct TactileCase {
  const char* name;
  Drawn drawn;
  std::vector<TactileRule> wanted;
  double gap_mm = 6.4;
};

std::vector<TactileCase> hand_made_cases() {
  const std::vector<Point> square = rectangle({20, 20}, 30, 30);
  return {
      {"nothing", Drawn(), {}},
      {"one line", Drawn().line({{20, 20}, {80, 20}}), {}},
      {"lines with 7 mm between",
       Drawn().line({{20, 20}, {80, 20}}).line({{20, 28}, {80, 28}}),
       {}},
      {"lines with 6 mm between",
       Drawn().line({{20, 20}, {80, 20}}).line({{20, 27}, {80, 27}}),
       {kGap}},
      {"6 mm are enough if embossed",
       Drawn().line({{20, 20}, {80, 20}}).line({{20, 27}, {80, 27}}),
       {},
       3.2},
      {"3 mm are not enough if embossed",
       Drawn().line({{20, 20}, {80, 20}}).line({{20, 24}, {80, 24}}),
       {kGap},
       3.2},
      {"wide lines have less between",
       Drawn().line({{20, 20}, {80, 20}}, 3).line({{20, 28}, {80, 28}}, 3),
       {kGap}},
      {"lines on each other",
       Drawn().line({{20, 20}, {80, 20}}).line({{30, 20.5}, {90, 20.5}}),
       {}},
      {"hatching of 5 lines, 5 mm", hatching(5, 5), {kGap, kGap, kGap, kGap}},
      {"hatching of 5 lines, 8 mm", hatching(5, 8), {}},
      {"crossing at 90 degrees", Drawn().line({{20, 50}, {80, 50}}).line({{50, 20}, {50, 80}}), {}},
      {"crossing at 45 degrees", Drawn().line({{20, 20}, {80, 80}}).line({{20, 50}, {80, 50}}), {}},
      {"crossing at 10 degrees",
       Drawn().line({{20, 50}, {160, 50}}).line({{20, 62}, {160, 37}}),
       {kGap, kGap}},
      {"corner of 60 degrees, one line", wedge(60, true), {}},
      {"corner of 60 degrees, two lines", wedge(60, false), {}},
      {"corner of 35 degrees, one line", wedge(35, true), {}},
      {"corner of 20 degrees, one line", wedge(20, true), {kGap}},
      {"corner of 20 degrees, two lines", wedge(20, false), {kGap}},
      {"hairpin", Drawn().line({{20, 20}, {80, 20}, {80, 25}, {20, 25}}), {kGap}},
      {"wide hairpin", Drawn().line({{20, 20}, {80, 20}, {80, 35}, {20, 35}}), {}},
      {"corner that does not close",
       Drawn().line({{20, 20}, {80, 20}}).line({{82.5, 20}, {82.5, 80}}),
       {kGap}},
      {"T", Drawn().line({{20, 20}, {80, 20}}).line({{50, 20}, {50, 60}}), {}},
      {"ladder",
       Drawn().line({{20, 20}, {80, 20}}).line({{20, 25}, {80, 25}}).line({{50, 20}, {50, 25}}),
       {kGap}},
      {"spiral of 5 mm",
       Drawn().line(
           {{50, 50}, {80, 50}, {80, 80}, {50, 80}, {50, 55}, {75, 55}, {75, 75}, {56, 75}}),
       {kGap}},
      {"square", Drawn().line(square), {}},
      {"square of four lines",
       Drawn()
           .line({square[0], square[1]})
           .line({square[1], square[2]})
           .line({square[2], square[3]})
           .line({square[3], square[0]}),
       {}},
      {"square in a square", Drawn().line(square).line(rectangle({5, 5}, 60, 60)), {}},
      {"square too near in a square",
       Drawn().line(square).line(rectangle({15, 15}, 40, 40)),
       {kGap}},
      {"small square", Drawn().line(rectangle({20, 20}, 8, 8)), {kSmallShape}},
      {"square with pointed corners of two short pieces",
       Drawn().line({{20, 20}, {80, 20}, {80.7, 19.3}, {81, 20}, {81, 70}, {20, 70}, {20, 20}},
                    2.0),
       {}},
      {"line with flat ends", Drawn().sharp_line({{20, 15}, {80, 15}}, 8), {}},
      {"V with flat ends and a pointed corner",
       Drawn().sharp_line({{20, 50}, {50, 35}, {80, 50}}, 6),
       {}},
      {"thin line too near a flat end",
       Drawn().sharp_line({{20, 15}, {80, 15}}, 8).line({{84, 5}, {84, 60}}),
       {kGap}},
      {"square with mitred corners", Drawn().sharp_line(rectangle({20, 20}, 60, 50), 2), {}},
      {"small square with mitred corners",
       Drawn().sharp_line(rectangle({20, 20}, 6, 6), 2),
       {kSmallShape}},
      {"long box with mitred corners and short sides",
       Drawn().sharp_line(rectangle({20, 20}, 40, 10), 2),
       {kShortSide, kShortSide}},
      {"long box with short sides",
       Drawn().line(rectangle({20, 20}, 40, 10)),
       {kShortSide, kShortSide}},
      {"circle", Drawn().circle({50, 50}, 15), {}},
      {"small circle", Drawn().circle({50, 50}, 4), {kSmallShape}},
      {"short line", Drawn().line({{20, 20}, {28, 20}}), {kSmallShape}},
      {"short line on a long one",
       Drawn().line({{20, 20}, {80, 20}}).line({{50, 20}, {50, 28}}),
       {}},
      {"dot", Drawn().line({{20, 20}, {20.4, 20}}, 3), {}},
      {"dot too near a line",
       Drawn().line({{20, 20}, {80, 20}}).line({{50, 25}, {50.4, 25}}, 3),
       {kGap}},
      {"five widths", widths(5), {}},
      {"six widths", widths(6), {kLineStyles}},
      {"area", Drawn().fill(rectangle({20, 20}, 30, 10)), {}},
      {"narrow area", Drawn().fill(rectangle({20, 20}, 30, 4)), {kNarrowArea}},
      {"areas of two colours",
       Drawn()
           .fill(rectangle({20, 20}, 30, 10))
           .fill(rectangle({20, 60}, 30, 10), {200, 0, 0, 255}),
       {kAreaStyles}},
      {"a page of A4", Drawn().line(rectangle({1, 1}, 295, 208)), {}},
      {"upright", Drawn().line(rectangle({1, 1}, 208, 295)), {}},
      {"a page of A3", Drawn().line(rectangle({1, 1}, 295, 418)), {kSize}},
      {"too wide for A4 only in one direction", Drawn().line(rectangle({1, 1}, 250, 250)), {kSize}},
  };
}

std::vector<TactileRule> rules_of(const std::vector<TactileFault>& faults) {
  std::vector<TactileRule> rules;
  for (const TactileFault& fault : faults) rules.push_back(fault.rule);
  return rules;
}

std::string names_of(const std::vector<TactileFault>& faults) {
  std::string text;
  for (const TactileFault& f : faults) {
    text += std::string(kTactileRuleNames[static_cast<std::size_t>(f.rule)]) + " at " +
            std::to_string(f.at.x) + ", " + std::to_string(f.at.y) + ": " +
            std::to_string(f.measured) + " for " + std::to_string(f.length_mm) + "\n";
  }
  return text;
}

TEST(TactileCheck, FindsWhatIsWrongInHandMadeCasesAndNothingElse) {
  std::vector<TactileCase> cases = hand_made_cases();
  EXPECT_GE(cases.size(), 40U);
  for (const TactileCase& c : cases) {
    const auto faults = check_tactile(c.drawn.document(), {.gap_mm = c.gap_mm});
    ASSERT_TRUE(faults) << c.name;
    EXPECT_EQ(rules_of(*faults), c.wanted) << c.name << ":\n" << names_of(*faults);
  }
}

TEST(TactileCheck, AFaultSaysWhereAndHowMuch) {
  const Drawn drawn = Drawn().line({{20, 20}, {80, 20}}).line({{40, 24}, {60, 23}}, 2.0);
  const auto faults = check_tactile(drawn.document());
  ASSERT_EQ(faults.value().size(), 1U);
  const TactileFault& f = faults.value()[0];
  EXPECT_NEAR(f.measured, 3.0 - 0.5 - 1.0, 0.02);
  EXPECT_EQ(f.limit, 6.4);
  EXPECT_NEAR(f.at.x, 60.0, 0.5);
  EXPECT_NEAR(f.at.y, 21.5, 0.1);
  EXPECT_NEAR(f.length_mm, 20.0 + 2.0 * 6.0, 2.0);  // until 6.4 mm beyond the ends, obliquely
  EXPECT_EQ(f.stroke, drawn.document().layers()[0].strokes[0]);
  EXPECT_EQ(f.other, drawn.document().layers()[0].strokes[1]);
}

TEST(TactileCheck, WhatIsNotSeenOnThePaperIsNotChecked) {
  const std::vector<Point> page = rectangle({0, 0}, 400, 500), narrow = rectangle({20, 20}, 30, 2);
  const Document white = Drawn().fill(page, {255, 255, 255, 255}).document();
  EXPECT_TRUE(check_tactile(white).value().empty());
  EXPECT_EQ(unseen_ink(white, {255, 255, 255, 255}).fills.size(), 1U);
  EXPECT_FALSE(check_tactile(white, {.paper = {200, 180, 140, 255}}).value().empty());
  EXPECT_TRUE(check_tactile(Drawn().fill(narrow, {0, 0, 0, 5}).document()).value().empty());
  EXPECT_TRUE(check_tactile(Drawn().fill(narrow, {250, 250, 255, 255}).document()).value().empty());
  EXPECT_EQ(check_tactile(Drawn().fill(narrow, {255, 255, 0, 255}).document()).value().size(), 1U);
}

TEST(TactileCheck, SeenInkDependsOnOpacityAndPaper) {
  const Rgba white{255, 255, 255, 255}, black{0, 0, 0, 255}, clear{0, 0, 0, 0};
  EXPECT_TRUE(is_seen(black, 1.0, white));
  EXPECT_FALSE(is_seen(black, 0.02, white));
  EXPECT_FALSE(is_seen(white, 1.0, white));
  EXPECT_FALSE(is_seen(white, 1.0, clear));
  EXPECT_TRUE(is_seen(white, 1.0, black));
  EXPECT_FALSE(is_seen(black, 1.0, black));
}

TEST(TactileCheck, ThinLinesAndDotsAreNamed) {
  for (const double width_mm : {0.05, 0.1, 0.4}) {
    const auto faults = check_tactile(Drawn().line({{20, 20}, {80, 20}}, width_mm).document());
    ASSERT_EQ(rules_of(*faults), std::vector{TactileRule::kThinLine}) << width_mm;
    EXPECT_NEAR(faults->front().measured, width_mm, 1e-9);
  }
  const auto dot = check_tactile(Drawn().line({{20, 20}, {20.06, 20}}, 0.3).document());
  EXPECT_EQ(rules_of(*dot), std::vector{TactileRule::kThinLine});
  EXPECT_EQ(dot->front().limit, TactileLimits::kDotMm);
}

TEST(TactileCheck, TheEnlargementIsTheSmallestWithoutFaultsBySize) {
  const auto drawing = [](double scale) {
    return Drawn()
        .line({{20 * scale, 20 * scale}, {80 * scale, 20 * scale}}, scale)
        .line({{20 * scale, 24 * scale}, {80 * scale, 24 * scale}}, scale)
        .line({{20 * scale, 60 * scale}, {20 * scale + 7 * scale, 60 * scale}}, scale)
        .document();
  };
  const auto faults = check_tactile(drawing(1.0)).value();
  const double times = tactile_enlargement(faults);
  EXPECT_DOUBLE_EQ(times, 2.2);  // 6.4 / 3 mm = 2.13
  EXPECT_TRUE(check_tactile(drawing(times)).value().empty());
  EXPECT_FALSE(check_tactile(drawing(times - 0.1)).value().empty());
  EXPECT_EQ(tactile_enlargement({}), 1.0);
}

TEST(TactileCheck, HiddenLayersAndDrawingsOfKilometres) {
  Document document = Drawn().line({{20, 20}, {80, 20}}).line({{20, 22}, {80, 22}}).document();
  LayerState hidden = document.layers()[0].state();
  hidden.visible = false;
  ASSERT_TRUE(document.apply(
      {.label = "Hide", .changes = {}, .layers = {{{1}, document.layers()[0].state(), hidden}}}));
  EXPECT_TRUE(check_tactile(document).value().empty());
  const auto refused = check_tactile(Drawn().line({{0, 0}, {2e5, 0}}).document());
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::kUnsupported);
}

/// A fault depends only on distances: turning or moving the drawing keeps rules and measures.
TEST(TactileCheck, DoesNotDependOnTheDirection) {
  for (const TactileCase& c : hand_made_cases()) {
    if (c.wanted == std::vector<TactileRule>{kSize}) continue;  // A4 has a direction
    Document turned = c.drawn.document();
    EditBuilder builder(turned);
    const Affine map = rotation(0.61803, {50, 50});
    for (const StrokeId id : turned.layers()[0].strokes) {
      StrokeData data = turned.find(id)->data();
      for (Point& p : data.points) p = apply(map, p);
      builder.replace(id, std::make_shared<const Stroke>(Stroke::create(std::move(data)).value()));
    }
    ASSERT_TRUE(turned.apply(std::move(builder).build("Turn")));
    std::vector<TactileRule> wanted = c.wanted;
    std::vector<TactileRule> found = rules_of(check_tactile(turned, {.gap_mm = c.gap_mm}).value());
    std::erase(found, kSize);  // the turned page of A4
    std::erase(found, kSmallShape);
    std::erase(wanted, kSmallShape);  // the size of a shape is that of its upright box
    EXPECT_EQ(found, wanted) << c.name;
  }
}

}  // namespace
}  // namespace felt::tactile_check_test
