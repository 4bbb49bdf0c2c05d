#include "felt/devices/simulated/landing_wait.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "felt/base/constants.h"
#include "felt/devices/simulated/pointer_hand.h"
#include "felt/devices/simulated/simulated_stylus.h"
#include "felt/rt/servo.h"

namespace felt::landing_wait_test {
namespace {

constexpr Point kStart{20.0, 20.0};

/// A mouse that moves to the place of a press, and draws a wave from there, 1000 places a second.
struct Motion {
  double far_mm = 50.0;
  int approach_ms = 30;
  int rest_ms = 0;  // before the press
  int draw_ms = 400;
  double mm_per_s = 100.0;
  int stall_ms = 0;  // the program reads nothing for so long, 100 ms after the press
};

struct Event {
  std::int64_t arrives_ms = 0;
  PointerEvent event;
};

Point press_of(const Motion& motion) {
  return {kStart.x + motion.far_mm, kStart.y};
}

/// Returns the place of the wave so many ms after the press.
Point wave(const Motion& motion, double ms) {
  const Point from = press_of(motion);
  return {from.x + 3.0 * std::sin(0.015 * ms), from.y + 1e-3 * motion.mm_per_s * ms};
}

std::vector<Event> events_of(const Motion& motion) {
  std::vector<Event> all;
  std::int64_t ms = 0;
  const auto add = [&](Point at, bool touching) {
    all.push_back({ms, {.time_ns = ms * kMs, .position = at, .touching = touching}});
  };
  add(kStart, false);
  ms = 800;
  for (int i = 1; i <= motion.approach_ms; ++i, ++ms) {
    add({std::lerp(kStart.x, press_of(motion).x, double(i) / motion.approach_ms), kStart.y}, false);
  }
  ms += motion.rest_ms;
  const std::int64_t press_ms = ms;
  for (int i = 0; i <= motion.draw_ms; ++i, ++ms) add(wave(motion, i), true);
  add(wave(motion, motion.draw_ms), false);
  for (Event& event : all) {
    const std::int64_t since_ms = event.arrives_ms - press_ms;
    if (since_ms < 100 || since_ms >= 100 + motion.stall_ms) continue;
    event.arrives_ms = press_ms + 100 + motion.stall_ms;
  }
  return all;
}

struct Drawn {
  std::vector<Point> ink;     // of the first contact
  int contacts = 0;           // how often it was put down
  std::vector<Point> begins;  // of each contact
  std::int64_t after_ms = 0;  // from the press to the contact
  std::int64_t takes_ms = 0;  // from the press to the end of the contact
  std::int64_t last_ms = 0;   // from the press to the end of the last contact
};

/// Plays the events; the times of the result count from `press_ms`.
Drawn draw(StylusPreset device, const SimulatedHand& hand, const std::vector<Event>& events,
           std::int64_t press_ms, double endless_mm = 1e6) {
  Capabilities& can = device.capabilities;
  can.workspace_min.x = can.workspace_min.y = -endless_mm;
  can.workspace_max.x = can.workspace_max.y = endless_mm;
  SimulatedStylus stylus(device, hand);
  const auto servo = std::make_unique<Servo>(stylus, ServoOptions{});
  PointerHand pointer(stylus, script_options_for(device, hand));
  Drawn drawn;
  std::size_t next = 0;
  bool was_down = false;
  for (std::int64_t ms = 0; ms < events.back().arrives_ms + 1500; ++ms) {
    for (; next < events.size() && events[next].arrives_ms <= ms; ++next) {
      pointer.point(events[next].event);
    }
    servo->step(ms * kMs);
    PenSample sample;
    while (servo->for_edit().pop(sample)) {
      const bool is_down = in_contact(sample);
      if (is_down && !was_down && ++drawn.contacts == 1) drawn.after_ms = ms - press_ms;
      if (is_down && !was_down) drawn.begins.push_back({sample.position.x, sample.position.y});
      if (is_down && drawn.contacts == 1) {
        drawn.ink.push_back({sample.position.x, sample.position.y});
        drawn.takes_ms = ms - press_ms;
      }
      if (is_down) drawn.last_ms = ms - press_ms;
      was_down = is_down;
    }
  }
  return drawn;
}

Drawn draw(const StylusPreset& device, const SimulatedHand& hand, const Motion& motion,
           double endless_mm = 1e6) {
  return draw(device, hand, events_of(motion), 800 + motion.approach_ms + motion.rest_ms,
              endless_mm);
}

/// The devices and hands whose stylus follows a hand that draws: friction holds it less than 4 mm
/// away, and it comes to rest within the wait. A light hand only guides.
bool follows(const StylusPreset& device, const SimulatedHand& hand) {
  if (!device.capabilities.has_force() || hand.name == "light") return false;
  const double mass_kg = device.mechanics.mass_kg + hand.mass_kg;
  return device.mechanics.friction_n < 4e-3 * hand.stiffness_n_per_m &&
         hand.stiffness_n_per_m > 600.0 * mass_kg;
}

/// Returns the distance that friction, or the speed of an almost resting stylus, leaves.
double off_mm(const StylusPreset& device, const SimulatedHand& hand) {
  return 0.7 + 1.2e3 * device.mechanics.friction_n / hand.stiffness_n_per_m;
}

template <class Use>
void for_each_pair(Use use) {
  int pairs = 0;
  for (const StylusPreset& device : stylus_presets()) {
    for (const SimulatedHand& hand : simulated_hands()) {
      if (!follows(device, hand)) continue;
      ++pairs;
      SCOPED_TRACE(std::string(device.name) + ", " + std::string(hand.name));
      use(device, hand);
    }
  }
  EXPECT_GE(pairs, 16);
}

TEST(LandingWait, R18_InkBeginsWhereTheMouseIsPressedAfterAFastMotion) {
  for (const Motion& motion :
       {Motion{}, Motion{.rest_ms = 100}, Motion{.far_mm = 150.0, .approach_ms = 100},
        Motion{.far_mm = 20.0, .approach_ms = 100}}) {
    for_each_pair([&](const StylusPreset& device, const SimulatedHand& hand) {
      const Drawn drawn = draw(device, hand, motion);
      ASSERT_GE(drawn.contacts, 1) << motion.far_mm;
      EXPECT_LT(distance(drawn.ink.front(), press_of(motion)), off_mm(device, hand))
          << motion.far_mm << " mm, " << motion.rest_ms << " ms";
    });
  }
}

TEST(LandingWait, R18_TheLineEndsWhereTheMouseIsReleased) {
  for_each_pair([](const StylusPreset& device, const SimulatedHand& hand) {
    const Motion motion;
    const Drawn drawn = draw(device, hand, motion);
    ASSERT_FALSE(drawn.ink.empty());
    EXPECT_LT(distance(drawn.ink.back(), wave(motion, motion.draw_ms)), 5.0);
    EXPECT_LT(drawn.takes_ms, motion.draw_ms + 250) << "has caught up";
  });
}

TEST(LandingWait, R18_APenThatRestsAboveThePlaceIsPutDownAtOnce) {
  for_each_pair([](const StylusPreset& device, const SimulatedHand& hand) {
    const Drawn drawn = draw(device, hand, {.far_mm = 30.0, .approach_ms = 60, .rest_ms = 1500});
    ASSERT_GE(drawn.contacts, 1);
    EXPECT_LE(drawn.after_ms, 50);
  });
}

TEST(LandingWait, R18_ATapAfterAFastMotionIsOneContact) {
  for_each_pair([](const StylusPreset& device, const SimulatedHand& hand) {
    const Motion tap{.draw_ms = 3, .mm_per_s = 0.0};
    const Drawn drawn = draw(device, hand, tap);
    EXPECT_EQ(drawn.contacts, 1);
    for (const Point at : drawn.ink) {
      EXPECT_LT(distance(at, press_of(tap)), off_mm(device, hand) + 0.5);
    }
  });
}

// A stylus that comes from high up is not let fall from the top of an oscillation, where it has no
// speed: it would bounce.
TEST(LandingWait, R18_ALineThatBeginsFarBelowIsOneContact) {
  int pairs = 0;
  for_each_pair([&](const StylusPreset& device, const SimulatedHand& hand) {
    // A soft hand may bounce, and so may a firm one with a heavy stylus.
    const double mass_kg = device.mechanics.mass_kg + hand.mass_kg;
    if (hand.stiffness_n_per_m < typical_hand().stiffness_n_per_m) return;
    if (hand.stiffness_n_per_m * mass_kg > 300.0) return;
    ++pairs;
    for (const double high_mm : {0.0, 4.0, 10.0, 16.0, 30.0}) {
      for (const double away_mm : {5.0, 40.0}) {
        std::vector<Event> events{{0, {.position = kStart, .height_mm = high_mm}}};
        std::int64_t ms = 800;
        const Point press = kStart + Vec{away_mm, away_mm};
        const auto add = [&](double right_mm, bool touching) {
          events.push_back({ms, {ms * kMs, press + Vec{right_mm, 0.0}, touching}});
        };
        for (int i = 0; i < 320; ++i, ++ms) add(0.3 * i, true);
        add(96.0, false);
        const Drawn drawn = draw(device, hand, events, 800);
        EXPECT_GE(drawn.takes_ms, 320) << high_mm << " mm up, " << away_mm << " mm away";
      }
    }
  });
  EXPECT_GE(pairs, 8);
}

/// Returns a line of 20 mm, and a press `pause_ms` after it, `off_mm` from its end.
std::vector<Event> line_and_press(int pause_ms, double off_mm, bool by_tablet) {
  std::vector<Event> all{{0, {.position = kStart}}};
  std::int64_t ms = 800;
  const auto add = [&](Point at, bool touching) {
    PointerEvent event{.time_ns = ms * kMs, .position = at, .touching = touching};
    if (by_tablet) event.pressure = touching ? 0.5 : 0.0;
    all.push_back({ms++, event});
  };
  for (int i = 0; i <= 200; ++i) add(kStart + Vec{0.1 * i, 0.0}, true);
  add(kStart + Vec{20.0, 0.0}, false);
  ms += pause_ms - 1;
  const Point press = kStart + Vec{20.0, off_mm};
  for (int i = 0; i <= 200; ++i) add(press + Vec{0.0, 0.1 * i}, true);
  add(press + Vec{0.0, 20.0}, false);
  return all;
}

TEST(LandingWait, R18_EachPressIsATouchOfItsOwn) {
  for (const bool by_tablet : {false, true}) {
    for (const int pause_ms : {0, 5, 60}) {
      for (const double away_mm : {0.0, 15.0}) {
        for_each_pair([&](const StylusPreset& device, const SimulatedHand& hand) {
          const std::vector<Event> events = line_and_press(pause_ms, away_mm, by_tablet);
          const Drawn drawn = draw(device, hand, events, 800);
          // A soft hand may bounce, so there may be more contacts.
          const Point press = kStart + Vec{20.0, away_mm};
          EXPECT_TRUE(
              std::any_of(drawn.begins.begin(), drawn.begins.end(),
                          [&](Point at) { return distance(at, press) < off_mm(device, hand); }))
              << pause_ms << " ms, " << away_mm << " mm";
        });
      }
    }
  }
}

/// Returns quick hatching: a press and 20 mm in 120 ms, then 80 ms in the air, `lines` times.
std::vector<Event> hatching(int lines) {
  std::vector<Event> all{{0, {.position = kStart}}};
  std::int64_t ms = 800;
  for (int line = 0; line < lines; ++line) {
    for (int i = 0; i < 200; ++i, ++ms) {
      const bool is_down = i < 120;
      const double part = is_down ? i / 120.0 : (200 - i) / 80.0;
      const Vec off{2.0 * line + (is_down ? 0.0 : (i - 120) / 40.0), 20.0 * part};
      all.push_back({ms, {.time_ns = ms * kMs, .position = kStart + off, .touching = is_down}});
    }
  }
  all.push_back({ms, {.time_ns = ms * kMs, .position = kStart}});
  return all;
}

// The waits of many quick strokes do not add up, and no stroke is lost.
TEST(LandingWait, R18_QuickHatchingStaysUpWithTheHand) {
  for_each_pair([](const StylusPreset& device, const SimulatedHand& hand) {
    constexpr int kLines = 120;
    const std::vector<Event> events = hatching(kLines);
    const Drawn drawn = draw(device, hand, events, 800);
    EXPECT_GE(drawn.contacts, kLines);
    EXPECT_LT(drawn.last_ms - (events.back().arrives_ms - 800), 1200);
  });
}

TEST(LandingWait, APlaceThatThePenCannotReachIsGivenUp) {
  const Drawn drawn = draw(*find_stylus_preset("premium"), typical_hand(), {.far_mm = 80.0}, 60.0);
  EXPECT_EQ(drawn.contacts, 1);
  EXPECT_LE(drawn.after_ms, 160 + (LandingWait::kMaxAboveNs + LandingWait::kMaxDownNs) / kMs);
}

/// Returns the largest distance of the ink from the wave.
double farthest_mm(const Drawn& drawn, const Motion& motion) {
  double farthest = 0.0;
  for (const Point at : drawn.ink) {
    double nearest = 1e9;
    for (int ms = 0; ms <= motion.draw_ms; ++ms) {
      nearest = std::min(nearest, distance(at, wave(motion, ms)));
    }
    farthest = std::max(farthest, nearest);
  }
  return farthest;
}

// A stylus with a body moves along all places that come late, and not across.
TEST(LandingWait, AStallCutsNoCurve) {
  const Motion steady{.rest_ms = 1500, .draw_ms = 700};
  Motion stalled = steady;
  stalled.stall_ms = 420;  // a whole period of the wave
  int pairs = 0;
  for_each_pair([&](const StylusPreset& device, const SimulatedHand& hand) {
    const double usual_mm = farthest_mm(draw(device, hand, steady), steady);
    if (usual_mm > 1.0) return;  // the stylus is too heavy for this hand
    ++pairs;
    EXPECT_LT(farthest_mm(draw(device, hand, stalled), stalled), 1.6 * usual_mm + 0.5);
  });
  EXPECT_GE(pairs, 6);
}

RC_GTEST_PROP(LandingWaitProperty, R18_InkBeginsAtThePress, ()) {
  std::vector<std::pair<const StylusPreset*, const SimulatedHand*>> pairs;
  for (const StylusPreset& device : stylus_presets()) {
    for (const SimulatedHand& hand : simulated_hands()) {
      if (follows(device, hand)) pairs.emplace_back(&device, &hand);
    }
  }
  const auto& [device, hand] = pairs[*rc::gen::inRange<std::size_t>(0, pairs.size())];
  Motion motion;
  motion.far_mm = *rc::gen::inRange(0, 200);
  motion.approach_ms = *rc::gen::inRange(20, 400);
  motion.rest_ms = *rc::gen::inRange(0, 200);
  motion.mm_per_s = *rc::gen::inRange(0, 200);
  const Drawn drawn = draw(*device, *hand, motion);
  RC_ASSERT(drawn.contacts >= 1);
  RC_ASSERT(distance(drawn.ink.front(), press_of(motion)) < off_mm(*device, *hand));
}

}  // namespace
}  // namespace felt::landing_wait_test
