// Simulated people choose from a ring without eyes (docs/design/forces.md#rings).
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <optional>

#include "felt/base/constants.h"
#include "felt/base/random.h"
#include "felt/devices/simulated/feedback_hand.h"
#include "felt/rt/servo.h"
#include "felt/rt/virtual_clock.h"
#include "felt/tools/choice_ring.h"

namespace felt::blind_ring_test {
namespace {

constexpr Point kMiddle{80.0, 80.0};
constexpr int kTries = 400;
constexpr double kHoverMm = 3.0, kPressMm = 1.2;
// Times of a choice: the forces are on, the pen has landed, moves, waits in the well, and lifts.
constexpr double kArmedS = 0.8, kLandedS = 1.1, kMoveS = 1.2, kWaitS = 1.6, kLiftS = 2.1;
constexpr double kEndS = 2.6;

/// How well people know directions without looking. Errors of direction do not depend on the
/// distance (Gordon, Ghilardi and Ghez 1994, DOI 10.1007/BF00241415); their size is chosen.
struct Practice {
  double own_deg = 5.0;     ///< standard deviation between people
  double try_deg = 5.0;     ///< standard deviation of the tries of a person
  double extent = 0.2;      ///< of the distance, as a share of it
  double landing_mm = 0.5;  ///< of the touch around the middle of the ring, per axis
};

enum class Feel : std::uint8_t { kWells, kSurfaceOnly };

double smooth(double from_s, double until_s, double t_s) noexcept {
  const double t = std::clamp((t_s - from_s) / (until_s - from_s), 0.0, 1.0);
  return t * t * t * (10.0 + t * (6.0 * t - 15.0));  // minimum jerk
}

/// What a person plans: where the pen touches, and where the movement ends.
struct Plan {
  Point from, to;

  [[nodiscard]] Vec3 at(double t_s) const noexcept {
    const Point p = from + smooth(kMoveS, kWaitS, t_s) * (to - from);
    const double down = smooth(kArmedS, kLandedS, t_s) - smooth(kLiftS, kLiftS + 0.3, t_s);
    return {p.x, p.y, kHoverMm - (kHoverMm + kPressMm) * down};
  }
};

Plan plan_for(std::size_t well, std::uint64_t seed, const Practice& practice, double radius_mm) {
  constexpr std::uint64_t kPeople = 50;
  Random own(1000 + seed % kPeople), random(5000 + seed);
  const double off_deg = practice.own_deg * own.normal() + practice.try_deg * random.normal();
  const double angle = kTau * (double(well) / double{ChoiceRing::kWells} + off_deg / 360.0);
  const double far_mm = radius_mm * std::max(0.4, 1.0 + practice.extent * random.normal());
  const Point from = kMiddle + practice.landing_mm * Vec{random.normal(), random.normal()};
  return {from, from + far_mm * Vec{std::sin(angle), -std::cos(angle)}};
}

Person without_eyes(Person person) {
  person.eye_gain_per_s = person.eye_noise_mm = 0.0;
  person.load_share = 0.0;  // the hand yields to the well
  return person;
}

/// What a person has chosen when the pen lifts, and how far the pen was from the middle of that
/// well before.
struct Choice {
  std::optional<std::size_t> well;
  double away_mm = 0.0;
};

/// Lets a person choose a well with the haptic loop.
Choice choose(std::size_t well, std::uint64_t seed, const Practice& practice, Feel feel) {
  StylusPreset preset = *find_stylus_preset("premium");
  center_workspace(preset.capabilities, kMiddle);
  const Capabilities& device = preset.capabilities;
  FeedbackHand hand(preset, without_eyes(person_of(seed)));
  const auto servo = std::make_unique<Servo>(
      hand, ServoOptions{.period_ns = device.period_ns, .limits = limits_for(device)});
  ChoiceRing ring(kMiddle, {0.0, -kRingMm}, {kRingMm, 0.0});
  const ChoiceRing closed = ring;
  const SurfaceMaterial& paper = surface_materials()[0];
  const Plan plan = plan_for(well, seed, practice, kRingMm);
  servo->publish(ring_force(ring, paper, device));
  servo->arm();
  VirtualClock clock(*servo);
  Choice choice;
  bool has_touched = false;
  for (int ticks = 0; 1e-9 * double(clock.next_ns()) < kEndS; ++ticks) {
    hand.aim({plan.at(1e-9 * double(clock.next_ns())), std::nullopt});
    const TickReport& tick = clock.tick();
    if (has_touched && !in_contact(tick.sample)) break;
    has_touched = has_touched || in_contact(tick.sample);
    const Point pen = on_page(tick.sample.position);
    ring.move(pen);
    choice.well = ring.chosen();
    if (choice.well) choice.away_mm = distance(pen, ring.well(*choice.well));
    // The edit thread publishes about 120 times a second.
    if (ticks % 8 == 0) {
      servo->publish(ring_force(feel == Feel::kWells ? ring : closed, paper, device));
    }
  }
  return choice;
}

/// The number of choices that are the ones that were meant, and the mean of Choice::away_mm.
struct Successes {
  int count = 0;
  double away_mm = 0.0;
};

Successes successes(const Practice& practice, Feel feel) {
  Successes sum;
  for (int i = 0; i < kTries; ++i) {
    const std::size_t well = std::size_t(i) % ChoiceRing::kWells;
    const Choice choice = choose(well, std::uint64_t(i) + 1, practice, feel);
    if (choice.well == well) ++sum.count;
    sum.away_mm += choice.away_mm / kTries;
  }
  return sum;
}

TEST(BlindRing, PeopleWithoutEyesChooseTheWellTheyMean) {
  const int count = successes({}, Feel::kWells).count;
  std::printf("%d of %d choices without eyes are the ones that were meant\n", count, kTries);
  EXPECT_GE(count, kTries * 95 / 100);
}

// What people with less practice achieve. The wells do not change what is chosen, because they have
// no force where the choice changes; they hold the pen in the choice. FELT_RING_DEG sets the
// directions' standard deviation.
TEST(BlindRing, WellsHoldThePenNearTheirMiddle) {
  const char* text = std::getenv("FELT_RING_DEG");
  const double deg = text ? std::strtod(text, nullptr) : 7.0;
  const Practice practice{.own_deg = deg, .try_deg = deg};
  const Successes with = successes(practice, Feel::kWells);
  const Successes without = successes(practice, Feel::kSurfaceOnly);
  std::printf(
      "%.0f and %.0f degrees: %d of %d, %.2f mm from the middle with wells; %d, %.2f mm without\n",
      deg, deg, with.count, kTries, with.away_mm, without.count, without.away_mm);
  EXPECT_EQ(with.count, without.count);
  EXPECT_LT(with.away_mm, 0.8 * without.away_mm);
}

}  // namespace
}  // namespace felt::blind_ring_test
