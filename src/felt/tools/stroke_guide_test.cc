#include "felt/tools/stroke_guide.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include "felt/base/constants.h"
#include "felt/document/edit_builder.h"

namespace felt::stroke_guide_test {
namespace {

using Kind = DrawingGuideKind;

DrawingGuidePtr made(DrawingGuide guide) {
  return std::make_shared<const DrawingGuide>(std::move(guide));
}

/// Moves a pen with one guide, and evaluates its force as the haptic loop does.
class Pen {
 public:
  explicit Pen(DrawingGuide held) : guides_{made(std::move(held))} {}

  void use(DrawingGuide held) { guides_ = {made(std::move(held))}; }
  void set_document(Document document) { document_ = std::move(document); }
  Force move(Point to, double z = -1.0, Vec velocity = {}) {
    time_ns_ += kMs;
    const PenSample sample{.time_ns = time_ns_,
                           .position = {to.x, to.y, z},
                           .velocity = {velocity.x, velocity.y, 0.0},
                           .pressure = {}};
    guide.update(sample, z < 0.0, guides_, document_, {});
    memory_.begin_tick(0.001);
    return guide.force() ? (*guide.force())(sample, memory_) : Force{};
  }
  Force rest(Point at, int ms, Vec velocity = {}) {
    Force force;
    for (int i = 0; i < ms; ++i) force = move(at, -1.0, velocity);
    return force;
  }
  /// Moves in a straight line, 0.05 mm in each ms.
  Force go(Point to) {
    const Point from = at_;
    const int steps = std::max(1, static_cast<int>(std::ceil(distance(from, to) / 0.05)));
    Force force;
    for (int i = 1; i <= steps; ++i) force = move(lerp(from, to, double(i) / steps));
    at_ = to;
    return force;
  }
  void touch(Point at) {
    move(at, 2.0);
    at_ = at;
    rest(at, 200);
  }
  void lift() { move(at_, 2.0); }

  StrokeGuide guide;

 private:
  std::vector<DrawingGuidePtr> guides_;
  Document document_;
  ForceMemory memory_;
  std::int64_t time_ns_ = 0;
  Point at_;
};

/// Returns a document with a stroke from (-60, 0) to (60, 0) that is slightly bent.
Document with_stroke() {
  Document document;
  StrokeData data{.points = {{-60.0, 0.0}, {-20.0, 8.0}, {20.0, -8.0}, {60.0, 0.0}},
                  .joints = {},
                  .widths = {{0.0, 1.0}, {1.0, 1.0}}};
  EditBuilder edit(document);
  edit.add(document.layers().front().id, std::make_shared<const Stroke>(*Stroke::create(data)));
  EXPECT_TRUE(document.apply(std::move(edit).build("Draw")));
  return document;
}

/// Returns a guide of each kind that has a force without a lead, and a place to touch, where the
/// nearest end is far.
struct Case {
  DrawingGuide guide;
  Point touch;
};
const std::vector<Case>& cases() {
  static const std::vector<Case> all{
      {{.kind = Kind::kRuler, .origin = {-90.0, 0.0}, .size_mm = 180.0}, {0.0, -0.5}},
      {{.kind = Kind::kLine, .angle_rad = 0.5}, {0.0, 0.5}},
      {{.kind = Kind::kParallels, .angle_rad = 2.0}, {3.0, 4.0}},
      {{.kind = Kind::kSetSquare, .origin = {-50.0, 0.0}, .size_mm = 100.0}, {0.0, 1.0}},
      {{.kind = Kind::kCompass, .origin = {0.0, -40.0}}, {0.0, 0.0}},
      {{.kind = Kind::kEllipse, .origin = {0.0, 30.0}, .size_mm = 60.0, .second_mm = 30.0},
       {0.0, 1.0}},
      {{.kind = Kind::kEllipses, .origin = {0.0, 50.0}, .size_mm = 60.0, .second_mm = 30.0}, {}},
      {{.kind = Kind::kPerspective, .points = {{600.0, 0.0}, {-600.0, 90.0}}}, {}},
      {{.kind = Kind::kProtractor, .origin = {-40.0, 0.0}, .size_mm = 120.0}, {0.0, 0.2}},
      {{.kind = Kind::kGrid, .size_mm = 8.0}, {0.5, 0.5}},
      {{.kind = Kind::kIsometricGrid, .size_mm = 8.0}, {0.5, 0.5}},
      {{.kind = Kind::kTrace, .stroke = {1}}, {0.0, 0.4}},
  };
  return all;
}

double limit_n(Kind kind) {
  const bool is_tick =
      kind == Kind::kProtractor || kind == Kind::kGrid || kind == Kind::kIsometricGrid;
  return is_tick ? 0.3 : 0.8;
}

RC_GTEST_PROP(StrokeGuide, ForcesOfAllKindsAreBoundedContinuousAcrossAndGainNoEnergy, ()) {
  const Case& one = cases()[*rc::gen::inRange<std::size_t>(0, cases().size())];
  const Kind kind = one.guide.kind;
  std::array<Vec, 4> waves;
  for (Vec& wave : waves) {
    wave = {0.1 * *rc::gen::inRange(-40, 41), 0.1 * *rc::gen::inRange(-40, 41)};
  }
  Pen pen(one.guide);
  pen.set_document(with_stroke());
  Point start = one.touch;
  pen.touch(start);
  if (kind == Kind::kPerspective) {
    start = start + Vec{4.0, 0.0};
    pen.go(start);
    pen.rest(start, 200);
  }
  constexpr int kSteps = 3000;
  Force last = pen.rest(start, 200);
  Point at = start;
  double work = 0.0;
  for (int i = 1; i <= kSteps; ++i) {
    Point to = start;
    for (std::size_t k = 0; k < waves.size(); ++k) {
      to += std::sin(0.5 * kTau * double(k + 1) * i / kSteps) * waves[k];
    }
    if (i == kSteps) to = start;
    const Force force = pen.move(to);
    RC_ASSERT(norm(force) <= limit_n(kind) + 1e-9);
    RC_ASSERT(norm(force - last) <= 0.06 + 3.0 * distance(at, to));
    work += work_mj(0.5 * (force + last), {to.x - at.x, to.y - at.y, 0.0});
    const auto shape = guide_shape(one.guide, one.touch);
    if (shape && kind != Kind::kSetSquare) {
      const Vec along = nearest_on(*shape, to).along;
      RC_ASSERT(std::fabs(force.x * along.x + force.y * along.y) < 0.03);
    }
    last = force;
    at = to;
  }
  RC_ASSERT(work < 0.08);
}

TEST(StrokeGuide, ARulerHoldsFromTheSideOfTheTouchOnly) {
  for (const double side : {-1.0, 1.0}) {
    Pen pen({.kind = Kind::kRuler, .origin = {-90.0, 0.0}, .size_mm = 180.0});
    pen.touch({0.0, 4.0 * side});
    EXPECT_EQ(pen.go({0.0, 20.0 * side}), Force{}) << "free to move away";
    EXPECT_EQ(pen.go({5.0, 0.3 * side}), Force{});
    EXPECT_NEAR(pen.go({5.0, 0.0}).y, side * 0.15, 1e-3) << "a light push rests on the edge";
    EXPECT_NEAR(pen.go({5.0, -1.0 * side}).y, side * 0.75, 1e-3);
    EXPECT_NEAR(pen.go({9.0, -1.0 * side}).x, 0.0, 1e-5);
    EXPECT_EQ(pen.go({9.0, -6.0 * side}), Force{}) << "pushed over the edge";
    EXPECT_EQ(pen.go({9.0, -1.0 * side}), Force{}) << "no force back onto it";
    EXPECT_EQ(pen.go({9.0, 0.1 * side}), Force{});
    pen.go({9.0, 2.0 * side});
    pen.rest({9.0, 2.0 * side}, 200);
    EXPECT_NEAR(pen.go({9.0, -1.0 * side}).y, side * 0.75, 1e-3) << "it holds again";
  }
}

TEST(StrokeGuide, APerspectiveChoosesAfterThreeMillimetresAndStaysThere) {
  Pen pen({.kind = Kind::kPerspective, .points = {{500.0, 0.0}}});
  pen.touch({0.0, 0.0});
  EXPECT_EQ(pen.go({2.9, 0.5}), Force{});
  EXPECT_EQ(pen.guide.ticks(), 0U);
  pen.go({3.5, 0.5});
  EXPECT_EQ(pen.guide.ticks(), 1U);
  EXPECT_NEAR(pen.rest({3.5, 0.5}, 200).y, -0.3, 1e-3);
  pen.go({3.5, 20.0});
  pen.go({3.5, 1.0});
  EXPECT_NEAR(pen.rest({3.5, 1.0}, 200).y, -0.6, 1e-3) << "still the same line";
  EXPECT_EQ(pen.guide.ticks(), 1U);
}

TEST(StrokeGuide, TheChoiceOfAPerspectiveIsFeltAsAClick) {
  Pen pen({.kind = Kind::kPerspective, .points = {{500.0, 0.0}}});
  pen.touch({0.0, 0.0});
  double most = 0.0, later = 0.0;
  for (int i = 0; i < 200; ++i) {
    const Force force = pen.move({0.05 * i, 0.0}, -1.0, {50.0, 0.0});
    EXPECT_LE(force.x, 1e-5) << "a brake";
    (0.05 * i < 5.0 ? most : later) = std::max(0.05 * i < 5.0 ? most : later, -force.x);
  }
  EXPECT_GT(most, 0.1);
  EXPECT_LT(later, 1e-6);
}

TEST(StrokeGuide, RaysTickWithinAThirdOfANewton) {
  Pen pen({.kind = Kind::kProtractor, .size_mm = 80.0});
  const auto at = [](double degrees) {
    const double a = degrees / kDegPerRad;
    return Point{40.0 * std::cos(a), 40.0 * std::sin(a)};
  };
  pen.touch(at(0.0));
  double most = 0.0;
  for (double degrees = 0.0; degrees < 47.0; degrees += 0.05) {
    const Force force = pen.move(at(degrees));
    most = std::max(most, norm(force));
  }
  EXPECT_EQ(pen.guide.ticks(), 3U);
  EXPECT_GT(most, 0.25);
  EXPECT_LE(most, 0.3);
  EXPECT_FALSE(pen.guide.exact_path()) << "an arc across rays is not a ray";
}

TEST(StrokeGuide, TheRayAtHalfATurnDoesNotTickAllTheTime) {
  Pen pen({.kind = Kind::kProtractor, .size_mm = 80.0});
  pen.touch({-40.0, 0.0});
  for (int i = 0; i < 200; ++i) pen.move({-40.0, i % 2 == 0 ? 0.05 : -0.05});
  EXPECT_EQ(pen.guide.ticks(), 0U);
  pen.lift();
  EXPECT_FALSE(pen.guide.exact_path());
  pen.touch({-20.0, 0.0});
  for (int i = 0; i < 200; ++i) pen.move({-20.0 - 0.2 * i, i % 2 == 0 ? 0.05 : -0.05});
  EXPECT_TRUE(pen.guide.exact_path()) << "it kept to one ray";
}

TEST(StrokeGuide, TheForceOfTheNextGuideGrowsFromZero) {
  const std::vector<DrawingGuide> guides{
      {.kind = Kind::kLine},
      {.kind = Kind::kParallels, .angle_rad = 0.3},
      {.kind = Kind::kTrace, .stroke = {1}},
      {.kind = Kind::kPerspective, .points = {{600.0, 0.0}}},
      {.kind = Kind::kProtractor, .origin = {-40.0, 0.0}, .size_mm = 120.0},
      {.kind = Kind::kGrid, .size_mm = 10.0}};
  // Leaves a guide and comes back farther along it, which starts a new hold; then rests.
  const auto draw = [](Pen& pen, int returns) {
    pen.touch({-8.0, 0.2});
    for (int i = -7; i < 0; ++i) pen.move({1.0 * i, 0.2});
    for (int i = 1; i <= returns; ++i) {
      pen.rest({20.0 * i, 40.0}, 3);
      pen.rest({20.0 * i, 0.2}, 200);
    }
    pen.lift();
  };
  for (std::size_t a = 0; a < guides.size(); ++a) {
    for (std::size_t b = 0; b < guides.size(); ++b) {
      for (int returns = 0; returns < 4; ++returns) {
        Pen pen(guides[a]);
        pen.set_document(with_stroke());
        draw(pen, returns);
        pen.use(guides[b]);
        const auto begins_at_zero = [&](int ms) {
          const Point at{0.6, 0.8};
          pen.move(at, 2.0);
          double first = 0.0;
          for (int i = 0; i < ms; ++i) first = std::max(first, norm(pen.move(at)));
          EXPECT_LT(first, 0.05 * std::max(0.2, norm(pen.rest(at, 200))))
              << a << ' ' << b << ' ' << returns;
          pen.lift();
        };
        begins_at_zero(1);
        pen.use(guides[2]);
        draw(pen, 1);
        pen.use(guides[a]);
        begins_at_zero(1);
      }
    }
  }
}

TEST(StrokeGuide, AGuideAfterAnotherNeedsTheWholeTimeToGrow) {
  const DrawingGuide line{.kind = Kind::kLine}, trace{.kind = Kind::kTrace, .stroke = {1}},
      parallels{.kind = Kind::kParallels, .origin = {0.0, 5.0}};
  for (int returns = 0; returns < 4; ++returns) {
    Pen pen(line);
    pen.set_document(with_stroke());
    pen.touch({0.0, 0.2});
    for (int i = 1; i <= returns; ++i) {
      pen.rest({25.0 * i, 20.0}, 3);
      pen.rest({25.0 * i, 1.0}, 300);
    }
    pen.lift();
    for (const DrawingGuide& next : {line, trace, line, parallels, trace, line}) {
      pen.use(next);
      const Point at{0.0, 1.0};
      pen.move(at, 2.0);
      const double early = norm(pen.rest(at, 20));
      const double late = norm(pen.rest(at, 300));
      EXPECT_LE(early, 0.2 * std::max(late, 0.1)) << "20 of 150 ms, after " << returns;
      pen.lift();
    }
  }
}

TEST(StrokeGuide, IsNearFromTheCaptureWidthUntilThePenLeavesTheGuide) {
  Pen pen({.kind = Kind::kLine});
  pen.touch({0.0, 30.0});
  EXPECT_TRUE(pen.guide.force()) << "the only guide";
  EXPECT_FALSE(pen.guide.is_near());
  pen.go({0.0, 3.2});
  EXPECT_FALSE(pen.guide.is_near());
  pen.go({0.0, 2.9});
  EXPECT_TRUE(pen.guide.is_near());
  pen.go({0.0, 4.9});
  EXPECT_TRUE(pen.guide.is_near());
  pen.go({0.0, 5.1});
  EXPECT_FALSE(pen.guide.is_near());
  pen.lift();
  EXPECT_FALSE(pen.guide.is_near());
  pen.use({.kind = Kind::kGrid, .size_mm = 20.0});
  pen.touch({10.0, 10.0});
  EXPECT_TRUE(pen.guide.is_near()) << "nodes are everywhere";
}

TEST(StrokeGuide, ATraceOfAClosedLineIsFeltAsClosed) {
  Document document;
  StrokeData data{.points = {{40.0, 0.0},
                             {40.0, 53.333},
                             {-40.0, 53.333},
                             {-40.0, 0.0},
                             {-40.0, -53.333},
                             {40.0, -53.333},
                             {40.0, 0.0}},
                  .joints = {JointKind::kCorner, JointKind::kCorner},
                  .closed = true,
                  .widths = {{0.0, 1.0}, {2.0, 1.0}}};
  EditBuilder edit(document);
  edit.add(document.layers().front().id, std::make_shared<const Stroke>(*Stroke::create(data)));
  ASSERT_TRUE(document.apply(std::move(edit).build("Draw")));
  Pen pen({.kind = Kind::kTrace, .stroke = {1}});
  pen.set_document(document);
  pen.touch({39.5, -10.0});
  pen.go({39.5, -2.0});
  // The force of an open path would fall to zero 5 mm beyond its end.
  for (double y = -2.0; y < 6.0; y += 0.05) pen.move({40.0, y});
  EXPECT_GT(norm(pen.rest({38.0, 6.0}, 300)), 0.3) << "the other end of the line holds the pen";
}

TEST(StrokeGuide, NodesAreOffForAFastPen) {
  Pen pen({.kind = Kind::kGrid, .size_mm = 10.0});
  pen.touch({1.0, 0.0});
  const auto pull = [&](double mm_per_s) { return -pen.rest({1.0, 0.0}, 200, {0.0, mm_per_s}).x; };
  EXPECT_NEAR(pull(0.0), 0.3, 1e-3);
  EXPECT_GT(pull(140.0), 0.25);
  EXPECT_EQ(pull(160.0), 0.0);
  EXPECT_EQ(pull(120.0), 0.0) << "hysteresis";
  EXPECT_GT(pull(90.0), 0.25);
  pen.go({5.0, 5.0});
  EXPECT_EQ(pen.rest({5.0, 5.0}, 50), Force{}) << "between the nodes";
}

TEST(StrokeGuide, LeavesAndReturnsWithHysteresis) {
  Pen pen({.kind = Kind::kLine});
  pen.touch({0.0, 1.0});
  EXPECT_NEAR(pen.go({0.0, 1.0}).y, -0.6, 1e-3);
  EXPECT_EQ(pen.go({0.0, 5.1}), Force{});
  EXPECT_EQ(pen.go({0.0, 3.1}), Force{});
  EXPECT_NEAR(pen.rest({0.0, 2.9}, 200).y, -0.8, 1e-3);
  pen.guide.stop();
  EXPECT_EQ(pen.rest({0.0, 1.0}, 200), Force{}) << "until the next touch";
  pen.lift();
  pen.touch({0.0, 1.0});
  EXPECT_NEAR(pen.go({0.0, 1.0}).y, -0.6, 1e-3);
}

TEST(StrokeGuide, OffersAnExactPathIfTheStrokeKeptToIt) {
  const auto after = [](DrawingGuide guide, std::initializer_list<Point> points) {
    Pen pen(std::move(guide));
    pen.touch(*points.begin());
    for (const Point p : points) pen.go(p);
    pen.lift();
    return pen.guide.exact_path();
  };
  const DrawingGuide line{.kind = Kind::kLine};
  const auto kept = after(line, {{0.0, 0.4}, {20.0, -0.4}, {40.0, 0.0}});
  ASSERT_TRUE(kept);
  EXPECT_NEAR(kept->from, 0.0, 1e-9);
  EXPECT_NEAR(kept->to, 40.0, 1e-9);
  EXPECT_FALSE(after(line, {{0.0, 0.4}, {20.0, 0.6}, {40.0, 0.0}})) << "too far away";
  EXPECT_FALSE(after(line, {{0.0, 0.0}, {20.0, 0.0}, {10.0, 0.0}})) << "turned back";
  EXPECT_FALSE(after(line, {{0.0, 0.0}, {1.5, 0.0}})) << "too short";
  EXPECT_TRUE(after(line, {{0.0, 0.0}, {-0.5, 0.0}, {30.0, 0.0}})) << "a wobble at the start";
  const DrawingGuide ruler{.kind = Kind::kRuler, .size_mm = 50.0};
  EXPECT_FALSE(after(ruler, {{20.0, 0.0}, {60.0, 0.0}})) << "beyond the end of the ruler";
  EXPECT_TRUE(after({.kind = Kind::kPerspective, .points = {{500.0, 0.0}}}, {{}, {30.0, 0.1}}));
  EXPECT_FALSE(after({.kind = Kind::kGrid}, {{0.0, 0.0}, {30.0, 0.0}}));
}

TEST(StrokeGuide, CountsTheTurnsAroundACircle) {
  Pen pen({.kind = Kind::kCompass, .origin = {0.0, 0.0}});
  pen.touch({20.0, 0.0});
  for (int i = 0; i <= 3000; ++i) {
    const double a = 1.1 * kTau * i / 3000;
    const Force force = pen.move({20.0 * std::cos(a), 20.0 * std::sin(a)});
    EXPECT_LT(norm(force), 0.02) << "the arc is free";
  }
  const auto path = pen.guide.exact_path();
  ASSERT_TRUE(path);
  EXPECT_NEAR(path->to - path->from, 1.1 * kTau, 1e-6);
  EXPECT_NEAR(std::get<GuideEllipse>(path->shape).a_mm, 20.0, 1e-9);
}

TEST(StrokeGuide, ShowsItsLineAndASpring) {
  Pen pen({.kind = Kind::kLine});
  pen.touch({0.0, 1.0});
  const auto springs = [&] {
    Overlay overlay;
    pen.guide.draw(overlay);
    EXPECT_EQ(overlay.outlines.size(), 1U) << "the line";
    pen.guide.draw_spring(overlay);
    return std::count_if(overlay.outlines.begin(), overlay.outlines.end(),
                         [](const auto& o) { return o.role == Overlay::Role::kTether; });
  };
  EXPECT_EQ(springs(), 1);
  pen.go({0.0, 9.0});
  EXPECT_EQ(springs(), 0) << "away from the guide";
}

TEST(StrokeGuide, AnyGuideGivesNumbers) {
  for (int kind = 0; kind < static_cast<int>(kDrawingGuideKinds); ++kind) {
    for (const double bad : {kNan, kInf, 0.0, -5.0, 1e300}) {
      for (int field = 0; field < 6; ++field) {
        DrawingGuide guide{.kind = static_cast<Kind>(kind), .points = {{1.0, 2.0}, {9.0, 9.0}}};
        if (guide.kind == Kind::kTeacher) guide.times_ms = {0.0, 10.0};
        (field == 0   ? guide.origin.x
         : field == 1 ? guide.angle_rad
         : field == 2 ? guide.size_mm
         : field == 3 ? guide.second_mm
         : field == 4 ? guide.step_rad
                      : guide.points[0].x) = bad;
        Pen pen(guide);
        pen.touch({1.0, 1.0});
        for (const Point p : {Point{5.0, 5.0}, Point{1e9, -1e9}}) {
          EXPECT_LE(norm(pen.rest(p, 20)), 0.8 + 1e-9) << kind << ' ' << field << ' ' << bad;
        }
      }
    }
  }
}

}  // namespace
}  // namespace felt::stroke_guide_test
