#include "felt/devices/simulated/feedback_hand.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "felt/base/constants.h"
#include "felt/devices/simulated/held_body.h"

namespace felt::feedback_hand_test {
namespace {

const StylusPreset& premium() {
  return *find_stylus_preset("premium");
}

Person calm_person() {
  Person person;
  person.wander_mm = person.tremor_mm = person.eye_noise_mm = person.motor_noise = 0.0;
  return person;
}

// The aim of a plan that moves to the right at 20 mm/s, just below the surface.
Aim moving_aim(int tick) {
  return {{20.0 + 0.02 * tick, 50.0, -0.5}, {}, 0};
}

// Draws a line to the right for `ticks` ms, while a force acts. Returns the positions of the pen.
std::vector<Point> draw_line(const Person& person, const Force& force, int ticks) {
  FeedbackHand hand(premium(), person);
  std::vector<Point> pen;
  for (int i = 0; i < ticks; ++i) {
    hand.aim(moving_aim(i));
    EXPECT_TRUE(hand.read(i * kMs));
    pen.push_back(on_page(hand.stylus().body().position()));
    EXPECT_TRUE(hand.write(force));
  }
  return pen;
}

TEST(FeedbackHand, CarriesOutThePlanAfterItsPreview) {
  const Person person = calm_person();
  const std::vector<Point> pen = draw_line(person, {}, 2000);
  const int preview = static_cast<int>(std::lround(person.preview_s * 1000.0));
  for (int i = 1000; i < 2000; ++i) {
    const Vec3 planned = moving_aim(i - preview).target_mm;
    EXPECT_NEAR(pen[static_cast<std::size_t>(i)].x, planned.x, 0.3) << i;
    EXPECT_NEAR(pen[static_cast<std::size_t>(i)].y, planned.y, 1e-9) << i;
  }
}

TEST(FeedbackHand, TheSamePersonAndCallsGiveTheSameBytes) {
  const Person person = person_of(5);
  const Force force{0.1, 0.2, 0.0};
  EXPECT_EQ(draw_line(person, force, 1500), draw_line(person, force, 1500));
  Person other = person;
  ++other.seed;
  EXPECT_NE(draw_line(person, force, 1500), draw_line(other, force, 1500));
}

TEST(FeedbackHand, YieldsToAForceAndThenReturnsToTheLine) {
  const std::vector<Point> pen = draw_line(calm_person(), {0.0, 0.3, 0.0}, 6000);
  double farthest = 0.0;
  for (const Point p : pen) farthest = std::max(farthest, std::abs(p.y - 50.0));
  EXPECT_GT(farthest, 0.5);
  EXPECT_LT(std::abs(pen.back().y - 50.0), 0.1);
}

TEST(FeedbackHand, StaysOffTheLineWithoutEyesAndLearning) {
  Person person = calm_person();
  person.eye_gain_per_s = person.load_share = 0.0;
  const std::vector<Point> pen = draw_line(person, {0.0, 0.3, 0.0}, 6000);
  // In balance, the force acts on the springs of grip and arm in series; the reflex helps the arm.
  const double expected_mm = 300.0 / person.grip().stiffness_n_per_m +
                             300.0 / (person.arm_n_per_m + person.reflex_n_per_m);
  EXPECT_NEAR(pen.back().y - 50.0, expected_mm, 0.02 * expected_mm);
}

TEST(FeedbackHand, ReactsToAForceAtOnceAndCorrectsItLater) {
  // Grip and arm yield within milliseconds; the eye cannot act before its delay has passed.
  Person blind = calm_person();
  blind.eye_gain_per_s = 0.0;
  const std::vector<Point> with = draw_line(calm_person(), {0.0, 0.3, 0.0}, 1400);
  const std::vector<Point> without = draw_line(blind, {0.0, 0.3, 0.0}, 1400);
  EXPECT_GT(with[50].y - 50.0, 1.0);
  const auto seen = static_cast<std::size_t>(1000.0 * calm_person().eye_delay_s);
  EXPECT_EQ(with[seen - 10].y, without[seen - 10].y);
  EXPECT_LT(std::abs(with.back().y - 50.0), 0.5 * std::abs(without.back().y - 50.0));
}

TEST(FeedbackHand, IsCalmAtEveryRateOfTheLoop) {
  for (const std::int64_t period_ns : {200'000, 1'000'000, 4'000'000}) {
    StylusPreset device = premium();
    device.capabilities.period_ns = period_ns;
    for (const double grip_n : {1.0, 3.0}) {
      Person person = calm_person();
      person.grip_n = grip_n;
      person.arm_kg = 0.067;  // the lightest arm of the population
      FeedbackHand hand(device, person);
      double off = 0.0;
      for (std::int64_t now = 0; now < 4'000 * kMs; now += period_ns) {
        hand.aim(moving_aim(static_cast<int>(now / kMs)));
        ASSERT_TRUE(hand.read(now));
        const bool pushes = now > 1'000 * kMs && now < 1'050 * kMs;
        ASSERT_TRUE(hand.write({0.0, pushes ? 1.0 : 0.0, 0.0}));
        if (now > 3'000 * kMs) {
          off = std::max(off, std::abs(hand.stylus().body().position().y - 50.0));
        }
      }
      EXPECT_LT(off, 0.2) << period_ns << " ns, grip " << grip_n << " N";
    }
  }
}

TEST(FeedbackHand, MovesAwayFromAnErrorThatItIsShown) {
  FeedbackHand hand(premium(), calm_person());
  for (int i = 0; i < 1000; ++i) {
    hand.aim(moving_aim(i));
    hand.see(Vec{0.0, 1.0});
    ASSERT_TRUE(hand.read(i * kMs));
  }
  EXPECT_LT(hand.stylus().body().position().y, 49.5);
}

// Before, a person saw only errors across a movement, and a force at rest displaced the pen for
// good.
TEST(FeedbackHand, ComesBackToThePointWhereItRests) {
  FeedbackHand hand(premium(), calm_person());
  double soon = 0.0;
  for (int i = 0; i < 3'000; ++i) {
    const bool begins = i < 500;
    hand.aim(begins ? moving_aim(i) : moving_aim(500));
    ASSERT_TRUE(hand.read(i * kMs));
    ASSERT_TRUE(hand.write({i > 1'000 ? 0.8 : 0.0, 0.0, 0.0}));
    if (i == 1'100) soon = hand.stylus().body().position().x;
  }
  const double rests_at = moving_aim(500).target_mm.x;
  EXPECT_GT(soon, rests_at + 1.0);
  EXPECT_NEAR(hand.stylus().body().position().x, rests_at, 0.5);
}

TEST(FeedbackHand, DrawsWithAMouse) {
  FeedbackHand hand(*find_stylus_preset("mouse"), calm_person());
  for (int i = 0; i < 1000; ++i) {
    hand.aim(moving_aim(i));
    ASSERT_TRUE(hand.read(i * kMs));
  }
  EXPECT_NEAR(hand.stylus().body().position().x, 35.0, 0.5);
}

/// Returns the heights of a pen that is held 2 mm above the surface, or presses on it with 0.6 N.
std::vector<double> heights(const Person& person, bool presses) {
  FeedbackHand hand(premium(), person);
  std::vector<double> z;
  for (int i = 0; i < 6000; ++i) {
    hand.aim({{50.0, 50.0, presses ? -2.7 : 2.0}, {}, 0});
    EXPECT_TRUE(hand.read(i * kMs));
    const double height = hand.stylus().body().position().z;
    EXPECT_TRUE(hand.write({0.0, 0.0, presses ? std::max(0.0, -0.5 * height) : 0.0}));
    if (i >= 1000) z.push_back(height);
  }
  return z;
}

double rms_around_mean(const std::vector<double>& values) {
  double mean = 0.0, square = 0.0;
  for (const double v : values) mean += v / static_cast<double>(values.size());
  for (const double v : values) square += (v - mean) * (v - mean);
  return std::sqrt(square / static_cast<double>(values.size()));
}

TEST(FeedbackHand, TheHeightWandersInTheAirAndThePressOnASurface) {
  Person person = calm_person();
  EXPECT_LT(rms_around_mean(heights(person, false)), 1e-9);
  person.depth_mm = 0.5;
  EXPECT_NEAR(rms_around_mean(heights(person, false)), 0.5, 0.2);
  EXPECT_LT(rms_around_mean(heights(person, true)), 1e-3) << "the surface holds the pen";
  person.press_noise_n = 0.05;
  const double of_press_n = 0.5 * rms_around_mean(heights(person, true));  // N/mm of the plane
  EXPECT_GT(of_press_n, 0.01);
  EXPECT_LT(of_press_n, 0.05);
}

TEST(FeedbackHand, ARestingHandIsStifferOnASurface) {
  Person free = calm_person(), resting = free;
  resting.rest = 3.0;
  const auto moved = [](const Person& person, double push_z) {
    FeedbackHand hand(premium(), person);
    for (int i = 0; i < 1500; ++i) {
      hand.aim({{50.0, 50.0, push_z > 0.0 ? -2.0 : 2.0}, {}, 0});
      EXPECT_TRUE(hand.read(i * kMs));
      EXPECT_TRUE(hand.write({i > 1000 ? 0.3 : 0.0, 0.0, push_z}));
    }
    return hand.stylus().body().position().x - 50.0;
  };
  EXPECT_LT(moved(resting, 0.5), 0.8 * moved(free, 0.5));
  EXPECT_EQ(moved(resting, 0.0), moved(free, 0.0));
}

TEST(FeedbackHand, AHandRestsOnATabletWhileItPresses) {
  const auto trembles = [](double rest, double pressure) {
    Person person = calm_person();
    person.rest = rest;
    person.force_noise_n = 0.05;
    FeedbackHand hand(*find_stylus_preset("tablet"), person);
    std::vector<double> x;
    for (int i = 0; i < 4000; ++i) {
      hand.aim({{50.0, 50.0, 0.0}, pressure, 0});
      EXPECT_TRUE(hand.read(i * kMs));
      if (i >= 1000) x.push_back(hand.stylus().body().position().x);
    }
    return rms_around_mean(x);
  };
  EXPECT_LT(trembles(3.0, 0.5), 0.8 * trembles(1.0, 0.5));
  EXPECT_EQ(trembles(3.0, 0.0), trembles(1.0, 0.0)) << "above the tablet";
}

TEST(FeedbackHand, WhoKnowsTheFrictionStaysOnTheLineFromTheStart) {
  StylusPreset rough = premium();
  rough.mechanics.friction_n = 0.3;
  const auto off = [&rough](const Person& person) {
    FeedbackHand hand(rough, person);
    double most = 0.0;
    for (int i = 0; i < 1000; ++i) {
      const double angle = 0.02 * i;  // a circle of 1.5 mm in 0.31 s
      hand.aim({{50.0 + 1.5 * std::cos(angle), 50.0 + 1.5 * std::sin(angle), -0.5}, {}, 0});
      EXPECT_TRUE(hand.read(i * kMs));
      EXPECT_TRUE(hand.write({}));
      const Point pen = on_page(hand.stylus().body().position());
      if (i > 400) most = std::max(most, std::abs(distance(pen, {50.0, 50.0}) - 1.5));
    }
    return most;
  };
  Person learning = calm_person(), knowing = learning;
  knowing.knows_friction = true;
  learning.load_share = knowing.load_share = 0.97;
  EXPECT_LT(off(knowing), 0.7 * off(learning));
}

TEST(FeedbackHand, SurvivesBadInputAndGaps) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  FeedbackHand hand(premium(), person_of(1));
  ASSERT_TRUE(hand.read(0));  // before the first aim
  hand.aim(Aim{{nan, 0.0, 0.0}});
  ASSERT_TRUE(hand.read(kMs));
  hand.aim(moving_aim(0));
  for (const std::int64_t ms : {2, 3, 3, 1, 4, 500'000, 500'001}) {
    const auto sample = hand.read(ms * kMs);
    ASSERT_TRUE(sample);
    EXPECT_TRUE(is_finite(sample->position));
  }
  EXPECT_EQ(hand.write({nan, 0.0, 0.0}).error(), DeviceFault::kBadData);
  hand.see(Vec{nan, 0.0});
  for (int i = 0; i < 1000; ++i) {
    const auto sample = hand.read(500'002 * kMs + i * kMs);
    ASSERT_TRUE(sample);
    ASSERT_TRUE(is_finite(sample->position));
  }
}

}  // namespace
}  // namespace felt::feedback_hand_test
