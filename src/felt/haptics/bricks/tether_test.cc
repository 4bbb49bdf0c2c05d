#include "felt/haptics/bricks/tether.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <numbers>

#include "felt/base/constants.h"
#include "felt/haptics/testing/feel_rig.h"

namespace felt::tether_test {
namespace {

Force pull(const Tether& tether, Point pen, double share = 1.0) {
  ForceMemory memory;
  memory.scale.lateral = share;
  return tether(rig::pen_at({pen.x, pen.y, -1}), memory);
}

TEST(Tether, R35_NoAnchorsNoForce) {
  EXPECT_EQ(pull(Tether(), {50, 50}), Force{});
  EXPECT_EQ(pull(Tether::translation({0, 0}, 0), {50, 50}), Force{});
  EXPECT_EQ(pull(Tether::rotation({0, 0}, {10, 0}, 0.0, 1), {0, 10}), Force{});
  EXPECT_EQ(pull(Tether::scale({0, 0}, {10, 0}, 0.0), {30, 0}), Force{});
  EXPECT_EQ(Tether().slopes(), Slopes{});
}

TEST(Tether, R35_MoreCurvesPullHarder) {
  for (const double d : {3.0, 10.0, 60.0}) {
    double last = 0.0;
    for (int anchors = 1; anchors <= 64; ++anchors) {
      const Force force = pull(Tether::translation({5, 5}, anchors), {5 + d * 0.6, 5 + d * 0.8});
      const double size = norm(force);
      if (d > 3.4 || size < 0.3 * d - 1e-9) {
        EXPECT_GT(size, last) << anchors << " anchors, " << d << " mm";
      }
      EXPECT_LE(size, 1.0);
      EXPECT_NEAR(force.x / size, -0.6, 1e-12);
      EXPECT_NEAR(force.y / size, -0.8, 1e-12);
      last = size;
    }
  }
}

TEST(Tether, R35_AreTheFiguresOfTheSpecification) {
  const int anchors[] = {1, 2, 4, 8, 16};
  const double force_n[] = {.36, .47, .60, .73, .84};
  for (int i = 0; i < 5; ++i) {
    EXPECT_NEAR(norm(pull(Tether::translation({0, 0}, anchors[i]), {10, 0})), force_n[i], 0.005);
  }
}

TEST(Tether, PrintedIsThePaperLiterally) {
  ForceLaw law = kTransformLaw;
  law.form = LawForm::kPaper;
  const Point anchors[] = {{3, 4}, {9, 1}, {-2, 7}};
  const Point middle{10.0 / 3.0, 4.0}, pen{12, -5};
  Vec sum{};
  for (const Point p : anchors) sum += pen - p;  // equation 10
  for (const Point grab : {pen, Point{50, 60}}) {
    const Force force = pull(Tether::translation(grab, 3).printed(middle), pen, 0.5);
    EXPECT_NEAR(force.x, -law.force_n(norm(sum)) * sum.x / norm(sum), 1e-12);
    EXPECT_NEAR(force.y, -law.force_n(norm(sum)) * sum.y / norm(sum), 1e-12);
  }
  EXPECT_EQ(norm(pull(Tether::translation(pen, 2).printed(pen), pen)), 0.0) << "they cancel";
  for (const double th : {0.01, 1.0, 3.0, -2.0}) {
    const Tether turn = Tether::rotation({0, 0}, {1, 0}, 30.0, 1).printed(middle);
    const Force force = pull(turn, {std::cos(th), std::sin(th)});
    const double size = law.force_n(30.0 * 2.0 * std::abs(std::sin(0.5 * th)));
    EXPECT_NEAR(force.x, (th > 0.0 ? size : -size) * std::sin(th), 1e-12);
    EXPECT_NEAR(force.y, (th > 0.0 ? -size : size) * std::cos(th), 1e-12);
  }
  for (const double s : {0.5, 0.999, 1.5}) {
    const Force force = pull(Tether::scale({0, 0}, {10, 0}, 30.0).printed(middle), {10 * s, 0});
    EXPECT_NEAR(force.x, (s > 1.0 ? -1.0 : 1.0) * law.force_n(30.0 * std::abs(s - 1.0)), 1e-12);
  }
  EXPECT_EQ(pull(Tether::translation({0, 0}, 0).printed({0, 0}), {50, 50}), Force{});
}

TEST(Tether, R35_NothingBeforeAnyMotion) {
  for (int anchors = 1; anchors <= 64; anchors *= 2) {
    EXPECT_EQ(norm(pull(Tether::translation({7, 8}, anchors), {7, 8})), 0.0);
    EXPECT_EQ(norm(pull(Tether::rotation({0, 0}, {7, 8}, 20.0 * anchors, 1), {7, 8})), 0.0);
    EXPECT_EQ(norm(pull(Tether::scale({0, 0}, {7, 8}, 20.0 * anchors), {7, 8})), 0.0);
  }
}

RC_GTEST_PROP(Tether, R36_RotationIsAcrossTheArmAndAgainstTheTurn, ()) {
  const Point centre{0.1 * *rc::gen::inRange(-99, 99), 0.1 * *rc::gen::inRange(-99, 99)};
  const double turn = 0.001 * *rc::gen::inRange(-3000, 3001);
  const double radius = 0.1 * *rc::gen::inRange(1, 500);
  RC_PRE(turn != 0.0);
  const Tether tether = Tether::rotation(centre, centre + Vec{20, 0}, 35.0, 1);
  const Vec arm{radius * std::cos(turn), radius * std::sin(turn)};
  const Force force = pull(tether, centre + arm);
  RC_ASSERT(std::abs(force.x * arm.x + force.y * arm.y) <= 1e-12 * radius);
  RC_ASSERT((force.x * perp(arm).x + force.y * perp(arm).y) * turn < 0.0);
  RC_ASSERT(norm(force) <= 1.0);
}

TEST(Tether, R36_GrowsOverTwoFullTurnsEitherWay) {
  for (const double way : {1.0, -1.0}) {
    const Tether tether = Tether::rotation({0, 0}, {20, 0}, 35.0, 1);
    ForceMemory memory;
    double last = -1.0;
    for (double turn = 0.0; turn <= 2.0 * kTau; turn += 0.01) {
      const Vec3 pen{20 * std::cos(way * turn), 20 * std::sin(way * turn), -1};
      const double size = norm(tether(rig::pen_at(pen), memory));
      ASSERT_GT(size, last) << turn;
      last = size;
    }
    EXPECT_NEAR(memory.turn_rad, way * 2.0 * kTau, 0.011);
    // Another gesture starts from zero.
    const Tether next = Tether::rotation({0, 0}, {20, 0}, 35.0, 2);
    EXPECT_LT(norm(next(rig::pen_at({20, 0.01, -1}), memory)), 0.02);
  }
}

TEST(Tether, R36_IsNothingAtTheCentre) {
  const Tether tether = Tether::rotation({3, 4}, {23, 4}, 350.0, 1);
  ForceMemory memory;
  for (const double radius : {2.0, 0.5, 0.01, 0.0}) {
    const Force force = tether(rig::pen_at({3, 4 + radius, -1}), memory);
    EXPECT_LE(norm(force), radius / 5.0);
    EXPECT_TRUE(is_finite(force));
  }
}

TEST(Tether, R37_ScaleIsTheSameBothWaysAndRadial) {
  const Tether tether = Tether::scale({0, 0}, {40, 30}, 80.0);  // r0 = 50 mm
  double last = 0.0;
  for (double s = 1.01; s < 9.9; s *= 1.05) {
    const Force up = pull(tether, {40 * s, 30 * s});
    const Force down = pull(tether, {40 / s, 30 / s});  // 5 mm from the centre and more
    EXPECT_NEAR(norm(up), norm(down), 1e-12);
    EXPECT_GT(norm(up), last);
    EXPECT_NEAR(up.x / norm(up), -0.8, 1e-12);  // back to s = 1
    EXPECT_NEAR(down.y / norm(down), 0.6, 1e-12);
    last = norm(up);
  }
  EXPECT_EQ(norm(pull(tether, {40, 30})), 0.0);
  EXPECT_EQ(scale_factor({1, 0}, {100, 0}), 20.0);
  EXPECT_EQ(scale_factor({100, 0}, {1, 0}), 0.05);
  EXPECT_EQ(norm(pull(tether, {4000, 3000})), norm(pull(tether, {8000, 6000})));
  EXPECT_EQ(norm(pull(tether, {0, 0})), 0.0);
}

TEST(Tether, R35_AConstrainedMoveIsHeldOnlyAlongItsAxis) {
  const Tether free = Tether::translation({0, 0}, 4), held = free.constrained();
  for (const Point pen : {Point{-10, -9}, Point{-10, 3}, Point{12, 0}, Point{7, 6}}) {
    const Force force = pull(held, pen);
    EXPECT_EQ(force.y, 0.0) << "nothing moves along y";
    EXPECT_LT(force.x * pen.x, 0.0);
    const Force along_x = pull(free, {pen.x, 0});
    const double from_diagonal = (std::abs(pen.x) - std::abs(pen.y)) / std::numbers::sqrt2;
    EXPECT_NEAR(std::abs(force.x), std::min(std::abs(along_x.x), 0.3 * from_diagonal), 1e-12);
    const Force across = pull(held, {pen.y, pen.x});
    EXPECT_EQ(across.x, 0.0);
    EXPECT_EQ(across.y, force.x);
  }
  EXPECT_EQ(norm(pull(held, {10, 10})), 0.0) << "either axis may be next";
}

TEST(Tether, R36_AConstrainedTurnIsHeldOnlyByTheStepsItMade) {
  const double degree = kTau / 360.0;
  const auto at = [&](const Tether& tether, double degrees) {
    return pull(tether, {30 * std::cos(degrees * degree), 30 * std::sin(degrees * degree)});
  };
  const Tether free = Tether::rotation({0, 0}, {30, 0}, 100.0, 1), held = free.constrained();
  for (const double degrees : {-7.4, -3.0, 0.0, 6.0, 7.4}) {
    EXPECT_EQ(norm(at(held, degrees)), 0.0) << degrees << ": nothing has turned";
  }
  for (const double degrees : {12.0, 15.0, 20.0, 22.4}) {
    EXPECT_NEAR(norm(at(held, degrees)), norm(at(free, 15.0)), 1e-9) << degrees;
    EXPECT_NEAR(norm(at(held, -degrees)), norm(at(free, 15.0)), 1e-9) << degrees;
  }
  EXPECT_NEAR(norm(at(held, 88.0)), norm(at(free, 90.0)), 1e-9);
}

TEST(Tether, R37_AScaleThatStandsStillPushesNoHarder) {
  const Tether held = Tether::scale({0, 0}, {50, 0}, 100.0).with_min_scale(0.5);
  EXPECT_GT(pull(held, {25, 0}).x, 0.0);
  EXPECT_NEAR(pull(held, {12, 0}).x, pull(held, {25, 0}).x, 1e-12);
}

struct Stiffest {
  double along = 0.0;
  double anywhere = 0.0;
};

/// Returns the largest stiffness, N/mm, with a share of the stiffness budget.
Stiffest stiffest(double share) {
  // Measures along the motion that does work: in any direction for a translation, across the arm
  // for a rotation, along the arm for a scale. In other directions slightly more is allowed,
  // because the arm turns with the pen.
  Stiffest found;
  constexpr double kH = 1e-5;
  for (int anchors = 1; anchors <= 64; anchors *= 2) {
    for (const double grab : {2.0, 8.0, 30.0, 90.0}) {
      const double radii = anchors * 25.0;
      const Tether tethers[] = {Tether::translation({grab, 0}, anchors),
                                Tether::rotation({0, 0}, {grab, 0}, radii, 1),
                                Tether::scale({0, 0}, {grab, 0}, radii),
                                Tether::translation({grab, 0}, anchors).constrained(),
                                Tether::rotation({0, 0}, {grab, 0}, radii, 1).constrained()};
      for (int i = 0; i < 3000; ++i) {
        // The points are denser near the grab point and the centre.
        const double r = 100.0 * (i % 60) * (i % 60) / 3600.0 + 0.013;
        const double angle = 0.37 * i;
        const Point near{(i % 2 == 0 ? grab : 0.0) + r * std::cos(angle), r * std::sin(angle)};
        if (near.x < 0.0 && std::abs(near.y) < 2 * kH) continue;  // where the angle wraps
        const Vec arm = normalized(near - Point{});
        for (int kind = 0; kind < 5; ++kind) {
          const Vec way = kind % 3 == 0 ? Vec{std::cos(1.3 * i), std::sin(1.3 * i)}
                                        : (kind % 3 == 1 ? perp(arm) : arm);
          const Force here = pull(tethers[kind], near, share);
          const auto slope = [&](Vec step) {
            return norm(pull(tethers[kind], near + kH * step, share) - here) / kH;
          };
          found.along = std::max(found.along, slope(way));
          found.anywhere = std::max(found.anywhere, slope(perp(way)));
        }
      }
    }
  }
  return found;
}

TEST(Tether, R38_IsNeverStifferThan300) {
  const Stiffest found = stiffest(1.0);
  EXPECT_LE(found.along, 0.300 * 1.001);
  EXPECT_LE(found.anywhere, 0.300 * 1.001);
  RecordProperty("stiffest_n_per_mm", std::to_string(found.along));
  RecordProperty("stiffest_across_n_per_mm", std::to_string(found.anywhere));
}

TEST(Tether, R38_R56_IsNeverStifferThanItsShareOfTheBudget) {
  for (const double share : {0.75, 0.5, 0.25}) {
    const Stiffest found = stiffest(share);
    EXPECT_LE(found.along, share * 0.300 * 1.001) << share;
    EXPECT_LE(found.anywhere, share * 0.300 * 1.001) << share;
  }
  EXPECT_EQ(norm(pull(Tether::rotation({0, 0}, {20, 0}, 35.0, 1), {0, 20}, 0.0)), 0.0);
}

// At 250 Hz and a delay of one tick the share is 0.75.
TEST(Tether, R30_R35_R56_ASmallerShareOfTheBudgetLeavesTheLevelOfTheLaw) {
  const double radii = 100.0;
  const Tether tethers[] = {Tether::translation({20, 0}, 4),
                            Tether::translation({20, 0}, 4).constrained(),
                            Tether::rotation({0, 0}, {20, 0}, radii, 1),
                            Tether::rotation({0, 0}, {20, 0}, radii, 1).constrained(),
                            Tether::scale({0, 0}, {20, 0}, radii)};
  const Point pens[] = {{35, 2}, {35, 2}, {15, 13}, {15, 13}, {35, 0}};
  for (std::size_t i = 0; i < std::size(tethers); ++i) {
    const double whole = norm(pull(tethers[i], pens[i]));
    EXPECT_GT(whole, 0.3) << i;  // where the force law is level
    EXPECT_NEAR(norm(pull(tethers[i], pens[i], 0.75)), whole, 1e-12) << i;
  }
  for (double d = 0.01; d < 60.0; d *= 1.1) {
    const double n = -pull(Tether::translation({0, 0}, 3), {d, 0}, 0.75).x;
    EXPECT_NEAR(n, std::min(kTransformLaw.level_n(3 * d), 0.75 * 0.225 * d), 1e-12);
  }
}

TEST(Tether, ThePassiveTranslationReturnsWhatItTook) {
  const Tether tether = Tether::translation({0, 0}, 5);
  double energy = 0.0;
  for (int i = 0; i < 10'000; ++i) {
    const auto at = [](int k) {
      const double a = kTau * k / 10'000;
      return Vec3{20 * std::sin(a), 10 * std::sin(2 * a), -1};
    };
    const Vec3 a = at(i);
    const Vec3 b = at(i + 1);
    energy += 0.5 * work_mj(pull(tether, on_page(a)) + pull(tether, on_page(b)), b - a);
  }
  EXPECT_NEAR(energy, 0.0, 1e-3);
}

TEST(Tether, TurnsAddUp) {
  double turn = 0.0;
  for (int i = 0; i <= 400; ++i) {
    turn = unwrapped_turn_rad({1, 0}, {std::cos(0.1 * i), std::sin(0.1 * i)}, turn);
  }
  EXPECT_NEAR(turn, 40.0, 1e-9);
  EXPECT_EQ(unwrapped_turn_rad({1, 0}, {0, 0}, 7.0), 7.0);
}

}  // namespace
}  // namespace felt::tether_test
