#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "felt/document/visible_strokes.h"
#include "felt/geometry/cubic.h"
#include "felt/replay/replay_machine.h"
#include "felt/tools/tool.h"

namespace felt::landing_test {
namespace {

std::int64_t ns_of(double ms) {
  return static_cast<std::int64_t>(std::llround(ms * 1e6));
}

/// A hand that draws lines, or dots if they have no length.
struct Lines {
  int count = 2;
  double landing_ms = 80.0;  // down, and up again
  double hover_mm = 4.0;
  double depth_mm = 2.0;
  double length_mm = 40.0;
  double speed_mm_per_s = 60.0;
  double rest_ms = 400.0;  // above the surface, between two lines
  double hold_ms = 0.0;    // on the surface, for a dot
  double apart_mm = 9.0;   // between neighbours
  std::uint32_t buttons = 0;
};

/// Draws the lines with a simulated device and hand, and returns the ink.
std::vector<StrokePtr> draw(std::string_view device, const SimulatedHand& hand,
                            const Lines& lines) {
  ReplayMachine machine(replay_settings(*find_stylus_preset(device), hand, true, {}, {}),
                        Document(), {});
  EXPECT_TRUE(machine.set_option("pencil.snap", "off"));
  double ms = 0.0, y = 20.0;
  const auto aim = [&](double x, double z) {
    HandEvent event;
    event.target = {x, y, z};
    event.buttons = lines.buttons;
    EXPECT_TRUE(machine.add({ns_of(ms), event}));
  };
  aim(20.0, lines.hover_mm);
  ms = 700.0;  // forces fade in for half a second
  for (int k = 0; k < lines.count; ++k) {
    aim(20.0, lines.hover_mm);
    ms += lines.landing_ms;
    aim(20.0, -lines.depth_mm);
    ms += lines.hold_ms + 1000.0 * lines.length_mm / lines.speed_mm_per_s;
    aim(20.0 + lines.length_mm, -lines.depth_mm);
    ms += lines.landing_ms;
    aim(20.0 + lines.length_mm, lines.hover_mm);
    ms += 0.75 * lines.rest_ms;
    y += lines.apart_mm;
    aim(20.0, lines.hover_mm);
    ms += 0.25 * lines.rest_ms;
  }
  aim(20.0, 8.0);
  EXPECT_TRUE(machine.play());
  return visible_strokes(machine.session().document());
}

/// Returns the largest width in the first half of a line over its width in the second half.
double blob_of(const Stroke& line) {
  double start = 0.0;
  std::vector<double> rest;
  const double x0 = line.segment(0).p[0].x;
  const double half = 0.5 * (line.segment(line.segment_count() - 1).p[3].x - x0);
  for (double u = 0.0; u <= line.segment_count(); u += 0.01) {
    const int i = std::min(static_cast<int>(u), line.segment_count() - 1);
    const double x = evaluate(line.segment(i), u - i).x - x0, width = line.width_mm(u);
    if (x < half) {
      start = std::max(start, width);
    } else if (x < 1.6 * half) {
      rest.push_back(width);
    }
  }
  std::nth_element(rest.begin(), rest.begin() + rest.size() / 2, rest.end());
  return start / rest[rest.size() / 2];
}

/// True for a device with a surface and a mass that a hand can put down in 80 ms: not for the 3 kg
/// of a HapticMASTER.
bool lands(const StylusPreset& device) {
  return device.renders_surface() && device.mechanics.mass_kg < 1.0;
}

/// The pen of a hand that does not press against the friction of the device stays in the air.
bool presses(const StylusPreset& device, const SimulatedHand& hand, double depth_mm) {
  const double push_n = 1e-3 * hand.stiffness_n_per_m * depth_mm;
  return push_n > device.mechanics.friction_n + 0.02;
}

// A hand that does not press against the friction of its device draws the thinnest lines, in which
// an error of the fitted width is largest.
TEST(Landing, R64_APenThatLandsIn80MillisecondsDrawsOneLineWithoutABlob) {
  const std::vector<Lines> lines{
      {.rest_ms = 1500.0},
      {.count = 6, .rest_ms = 400.0},  // the pen still swings when the next line begins
      {.landing_ms = 40.0, .rest_ms = 1500.0},
      {.landing_ms = 60.0, .rest_ms = 1500.0},
      {.length_mm = 120.0, .rest_ms = 1500.0},
  };
  for (const StylusPreset& device : stylus_presets()) {
    if (!lands(device)) continue;
    for (const SimulatedHand& hand : simulated_hands()) {
      for (std::size_t i = 0; i < lines.size(); ++i) {
        SCOPED_TRACE(std::string(device.name) + ", " + std::string(hand.name) + ", lines " +
                     std::to_string(i));
        const std::vector<StrokePtr> ink = draw(device.name, hand, lines[i]);
        ASSERT_EQ(ink.size(), static_cast<std::size_t>(lines[i].count));
        for (const StrokePtr& line : ink) EXPECT_LE(blob_of(*line), 1.2);
      }
    }
  }
}

TEST(Landing, R64_AStraightLineHasNoBlobEither) {
  for (const char* device : {"premium", "touch", "omega"}) {
    for (const double length_mm : {10.0, 40.0}) {  // the short line ends before the pen has settled
      SCOPED_TRACE(std::string(device) + ", " + std::to_string(length_mm));
      const std::vector<StrokePtr> ink =
          draw(device, *find_hand("typical"),
               {.length_mm = length_mm, .rest_ms = 1500.0, .buttons = kFirstModifier});
      ASSERT_EQ(ink.size(), 2u);
      for (const StrokePtr& line : ink) {
        EXPECT_EQ(line->segment_count(), 1);
        EXPECT_LE(blob_of(*line), 1.2);
      }
    }
  }
}

// If a hand cannot press against the friction of the device, its pen stays in the air.
RC_GTEST_PROP(LandingProperty, R64_DrawsOneLineForAnyDeviceHandTimeAndSpeed, ()) {
  const auto devices = stylus_presets();
  const auto hands = simulated_hands();
  const StylusPreset& device = devices[*rc::gen::inRange<std::size_t>(0, devices.size())];
  const SimulatedHand& hand = hands[*rc::gen::inRange<std::size_t>(0, hands.size())];
  RC_PRE(lands(device));
  Lines lines;
  lines.landing_ms = *rc::gen::inRange(60, 201);
  lines.depth_mm = 0.1 * *rc::gen::inRange(10, 31);
  lines.hover_mm = 6.0 - lines.depth_mm;
  lines.speed_mm_per_s = *rc::gen::inRange(30, 151);
  lines.length_mm = 0.6 * lines.speed_mm_per_s;
  lines.rest_ms = 1500.0;  // the softest hand takes a second to come to rest above the next line
  RC_PRE(presses(device, hand, lines.depth_mm));
  RC_ASSERT(draw(device.name, hand, lines).size() == 2u);
}

TEST(Landing, R64_LinesAndDotsThatTheHandLiftsBetweenStaySeparate) {
  for (const StylusPreset& device : stylus_presets()) {
    if (!lands(device)) continue;
    for (const SimulatedHand& hand : simulated_hands()) {
      // A hand that cannot carry the arm along draws no separate dots with any rule.
      const double natural_hz =
          std::sqrt(hand.stiffness_n_per_m / (hand.mass_kg + device.mechanics.mass_kg)) /
          (2.0 * std::numbers::pi);
      if (natural_hz < 4.0 || !presses(device, hand, 2.0)) continue;
      SCOPED_TRACE(std::string(device.name) + ", " + std::string(hand.name));
      // Hatching of 8 mm with four strokes a second, dots, and dots on one spot.
      EXPECT_EQ(draw(device.name, hand,
                     {.count = 6,
                      .landing_ms = 60.0,
                      .length_mm = 8.0,
                      .speed_mm_per_s = 120.0,
                      .rest_ms = 80.0,
                      .apart_mm = 2.0})
                    .size(),
                6u);
      const Lines dots{.count = 6,
                       .landing_ms = 60.0,
                       .length_mm = 0.0,
                       .rest_ms = 80.0,
                       .hold_ms = 60.0,
                       .apart_mm = 4.0};
      EXPECT_EQ(draw(device.name, hand, dots).size(), 6u);
      Lines taps = dots;
      taps.apart_mm = 0.0;
      EXPECT_EQ(draw(device.name, hand, taps).size(), 6u);
    }
  }
}

}  // namespace
}  // namespace felt::landing_test
