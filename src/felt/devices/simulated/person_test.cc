#include "felt/devices/simulated/person.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace felt::person_test {
namespace {

double duration_s(const RecordedPath& movement) {
  return 1e-9 * static_cast<double>(*movement.back().time_ns);
}

std::vector<Point> circle(double radius) {
  std::vector<Point> via;
  for (int i = 0; i <= 32; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / 32;
    via.push_back({50.0 + radius * std::cos(angle), 50.0 + radius * std::sin(angle)});
  }
  return via;
}

TEST(Person, TheSameSeedGivesTheSamePeople) {
  const std::vector<Person> a = population(5, 7), b = population(5, 7), c = population(5, 8);
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].seed, b[i].seed);
    EXPECT_EQ(a[i].pace, b[i].pace);
    EXPECT_EQ(a[i].grip_n, b[i].grip_n);
    EXPECT_NE(a[i].pace, c[i].pace);
  }
  EXPECT_NE(a[0].pace, a[1].pace);
}

RC_GTEST_PROP(Person, IsWithinTheRangesOfTheTable, (std::uint64_t seed)) {
  const Person person = person_of(seed);
  RC_ASSERT(person.preview_s >= 0.2 && person.preview_s <= 0.3);
  RC_ASSERT(person.eye_delay_s >= 0.12 && person.eye_delay_s <= 0.15);
  RC_ASSERT(person.arm_delay_s >= 0.03 && person.arm_delay_s <= 0.05);
  RC_ASSERT(person.grip_n >= 1.0 && person.grip_n <= 3.0);
  RC_ASSERT(person.power >= 0.0 && person.power <= 0.45);
  RC_ASSERT(person.pace > 0.0 && person.arm_kg > 0.0 && person.scatter > 0.0);
}

TEST(Person, AFirmerGripIsStiffer) {
  Person loose, firm;
  loose.grip_n = 1.0;
  firm.grip_n = 3.0;
  EXPECT_GT(firm.grip().stiffness_n_per_m, 2.0 * loose.grip().stiffness_n_per_m);
  EXPECT_GT(firm.grip().damping_n_s_per_m, 2.0 * loose.grip().damping_n_s_per_m);
}

TEST(PersonModel, NamesAreFoundAndTheFirstModelChangesNothing) {
  for (const PersonModel model : kPersonModels) {
    EXPECT_EQ(find_person_model(person_model_name(model)), model);
  }
  EXPECT_FALSE(find_person_model("nobody"));
  const Person person = person_of(3), same = in_model(person, PersonModel::kProportional);
  EXPECT_EQ(same.motor_noise, person.motor_noise);
  EXPECT_EQ(same.load_share, person.load_share);
  EXPECT_EQ(in_the_air(same).pace, person.pace);
  EXPECT_EQ(on_a_plane(same, 0.3).pace, person.pace);
}

RC_GTEST_PROP(PersonModel, PeopleAreFasterInTheAirAndSlowerAgainstFriction, (std::uint64_t seed)) {
  for (const PersonModel model : kPersonModels) {
    if (model == PersonModel::kProportional) continue;
    const Person person = in_model(person_of(seed), model);
    RC_ASSERT(in_the_air(person).pace > 1.1 * person.pace);
    RC_ASSERT(on_a_plane(person, 0.05).pace == person.pace);
    RC_ASSERT(on_a_plane(person, 0.25).pace < person.pace);
    RC_ASSERT(person.load_share > 0.75 && person.load_share < 1.0);
  }
}

RC_GTEST_PROP(PlanMovement, GoesFromTheFirstPointToTheLastInStepsOfAMillisecond,
              (std::uint64_t seed)) {
  const Person person = person_of(seed);
  const RecordedPath movement = plan_movement(person, circle(10.0), seed);
  RC_ASSERT(distance(movement.front().position, {60.0, 50.0}) < 0.5);
  RC_ASSERT(distance(movement.back().position, {60.0, 50.0}) < 0.5);
  for (std::size_t i = 0; i < movement.size(); ++i) {
    RC_ASSERT(*movement[i].time_ns == static_cast<std::int64_t>(i) * 1'000'000);
    // Muscles cut curves, more so at a high speed.
    RC_ASSERT(std::abs(distance(movement[i].position, {50.0, 50.0}) - 10.0) < 1.5);
  }
}

TEST(PlanMovement, IsSlowerInCurvesAndInTunnels) {
  Person person;
  person.scatter = 0.0;
  const double length = 20.0 * std::numbers::pi;
  const double curved_s = duration_s(plan_movement(person, circle(10.0)));
  const std::vector<Point> line{{0.0, 0.0}, {length, 0.0}};
  const double straight_s = duration_s(plan_movement(person, line));
  EXPECT_GT(curved_s, 1.2 * straight_s);
  // Steering law (Accot, Zhai, CHI 1997): the duration is proportional to length / width.
  const double wide_s = duration_s(plan_movement(person, line, 0, 1.0));
  const double narrow_s = duration_s(plan_movement(person, line, 0, 0.5));
  EXPECT_NEAR(narrow_s / wide_s, 2.0, 0.1);
}

TEST(PlanMovement, VariesFromTrialToTrial) {
  const Person person = person_of(3);
  const std::vector<Point> via = circle(8.0);
  EXPECT_EQ(duration_s(plan_movement(person, via, 1)), duration_s(plan_movement(person, via, 1)));
  EXPECT_NE(duration_s(plan_movement(person, via, 1)), duration_s(plan_movement(person, via, 2)));
}

TEST(PlanMovement, AcceptsAnyPoints) {
  const Person person;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(plan_movement(person, {}).empty());
  EXPECT_TRUE(plan_movement(person, std::vector<Point>{{nan, 0.0}}).empty());
  const RecordedPath dot = plan_movement(person, std::vector<Point>{{1.0, 2.0}, {1.0, nan}});
  ASSERT_FALSE(dot.empty());
  EXPECT_EQ(dot.back().position, (Point{1.0, 2.0}));
  EXPECT_GE(duration_s(dot), 0.05);
  EXPECT_FALSE(plan_movement(person, std::vector<Point>{{1.0, 2.0}, {1.0, 2.0}}).empty());
}

}  // namespace
}  // namespace felt::person_test
