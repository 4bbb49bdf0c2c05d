#include "felt/devices/simulated/scripted_hand.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "felt/devices/simulated/held_body.h"
#include "felt/devices/simulated/samples/drawings.h"
#include "felt/devices/simulated/simulated_stylus.h"

namespace felt::scripted_hand_test {
namespace {

struct Drawn {
  int strokes = 0;
  double worst_mm = 0.0;     // largest distance of a drawn sample from the wanted lines
  double max_speed = 0.0;    // mm/s
  double max_press_n = 0.0;  // largest force of the surface's spring
  double max_hover_press_n = 0.0;
};

double distance_to(const std::vector<RecordedPath>& lines, Point p) {
  double best = 1e9;
  for (const RecordedPath& line : lines) {
    for (const RecordedPoint& q : line) best = std::min(best, distance(p, q.position));
  }
  return best;
}

// Plays a script with a stylus above a surface. Lifts shorter than 3 ms do not end a stroke.
Drawn play(const std::vector<TimedAim>& script, const StylusPreset& device,
           const HandScriptOptions& options, const std::vector<RecordedPath>& lines) {
  SimulatedStylus stylus(device, options.hand);
  Drawn drawn;
  int lifted = 99;
  for (const TimedAim& aim : script) {
    stylus.aim(aim.target_mm, aim.pressure, 0);
    const PenSample s = stylus.read(aim.time_ns).value();
    const double spring_n = 1e-3 * options.plane_n_per_m * depth_mm(s);
    const double push_n = spring_n > 0.0 ? std::max(spring_n - 2e-3 * s.velocity.z, 0.0) : 0.0;
    EXPECT_TRUE(stylus.write({0, 0, push_n}).has_value());
    drawn.max_speed = std::max(drawn.max_speed, norm(stylus.body().velocity()));
    drawn.max_press_n = std::max(drawn.max_press_n, spring_n);
    if (in_contact(s)) {
      drawn.strokes += lifted >= 3 ? 1 : 0;
      lifted = 0;
      if (aim.time_ns % 5'000'000 == 0) {
        drawn.worst_mm = std::max(drawn.worst_mm, distance_to(lines, on_page(s.position)));
      }
    } else {
      ++lifted;
    }
  }
  return drawn;
}

TEST(HandScript, ThePenTiltsAsItDid) {
  const RecordedPath leaning{{{10, 10}, 0.5, 0, 20.0}, {{30, 10}, 0.5, 400'000'000, 60.0}};
  const RecordedPath unknown{{{10, 30}, 0.5, 0}, {{30, 30}, 0.5, 400'000'000}};
  const HandScriptOptions options =
      script_options_for(*find_stylus_preset("touch"), typical_hand());
  const auto aims = script_hand(std::vector<RecordedPath>{leaning}, options);
  EXPECT_EQ(aims.front().tilt_deg, 20.0) << "held so before it lands";
  EXPECT_EQ(aims.back().tilt_deg, 60.0);
  double last_deg = 20.0;
  for (const TimedAim& aim : aims) {
    ASSERT_GE(aim.tilt_deg.value(), last_deg);
    ASSERT_LE(*aim.tilt_deg - last_deg, 0.2) << "40 degrees in 400 ms, evenly";
    last_deg = *aim.tilt_deg;
  }
  for (const TimedAim& aim : script_hand(std::vector<RecordedPath>{unknown}, options)) {
    ASSERT_EQ(aim.tilt_deg, std::nullopt);
  }
}

std::vector<RecordedPath> recorded(std::span<const Gesture> gestures, const HandOptions& how) {
  WritingHand hand(how);
  std::vector<RecordedPath> paths;
  for (const Gesture& g : gestures) {
    RecordedPath path;
    for (const HandSample& s : hand.draw(g)) path.push_back({s.position, s.pressure, s.time_ns});
    paths.push_back(path);
  }
  return paths;
}

// Every stroke of a page, dots included, becomes exactly one contact, with every device and hand.
TEST(HandScript, LosesNoStroke) {
  std::vector<Gesture> gestures = cursive("hello", {10, 30}, 6.0);
  gestures.push_back({.via = {{20, 60}}});
  gestures.push_back({.via = {{23, 60}}, .pressure = 0.05});
  gestures.push_back(zigzag({30, 60}, {5, 8}, 4));
  const auto lines = recorded(gestures, {.seed = 4});
  for (const char* name : {"worst", "touch", "premium", "inverse3", "omega", "mouse", "tablet"}) {
    const StylusPreset& device = *find_stylus_preset(name);
    for (const SimulatedHand& hand : simulated_hands()) {
      HandScriptOptions options = script_options_for(device, hand);
      options.friction = 0.0;  // the simulated surface has no friction
      const Drawn drawn = play(script_hand(lines, options), device, options, lines);
      EXPECT_EQ(drawn.strokes, static_cast<int>(lines.size())) << name << ", " << hand.name;
      EXPECT_LT(drawn.max_speed, 600.0) << name << ", " << hand.name;
    }
  }
}

// The hand draws the wanted lines: a typical hand with an error below one millimetre, the tablet
// exactly.
TEST(HandScript, DrawsWhatWasMeant) {
  const std::vector<Gesture> gestures{straight_line({10, 10}, {60, 12}), loops({20, 40}, 6, 3, 4)};
  const auto lines = recorded(gestures, {.interval_ns = 1'000'000, .seed = 2});
  const auto worst = [&](const char* device_name, const char* hand_name) {
    const StylusPreset& device = *find_stylus_preset(device_name);
    HandScriptOptions options = script_options_for(device, *find_hand(hand_name));
    options.friction = 0.0;
    return play(script_hand(lines, options), device, options, lines).worst_mm;
  };
  EXPECT_LT(worst("tablet", "typical"), 0.1);
  EXPECT_LT(worst("worst", "firm"), 0.5);
  EXPECT_LT(worst("premium", "typical"), 1.0);
  EXPECT_LT(worst("touch", "typical"), 1.5);
}

// In the middle of a steady line with pressure p, the surface pushes with F0 + p (F1 - F0).
TEST(HandScript, PressesAsHardAsThePressureSays) {
  for (const SimulatedHand& hand : simulated_hands()) {
    const StylusPreset& device = *find_stylus_preset("worst");
    const HandScriptOptions options = script_options_for(device, hand);
    for (const double p : {0.0, 0.3, 1.0}) {
      RecordedPath line;
      for (int i = 0; i <= 300; ++i) {
        line.push_back({{10.0 + 0.1 * i, 20.0}, p, std::int64_t{10'000'000} * i});
      }
      const auto script = script_hand(std::vector<RecordedPath>{line}, options);
      const Drawn drawn = play(script, device, options, {line});
      const double wanted_n = options.light_n + p * (options.full_n - options.light_n);
      EXPECT_GT(drawn.max_press_n, 0.9 * wanted_n) << hand.name << ", p " << p;
      EXPECT_LT(drawn.max_press_n, 1.25 * wanted_n + 0.1) << hand.name << ", p " << p;
    }
  }
}

TEST(HandScript, TimesAreEvenAndWaysInTheAirAreSmooth) {
  const auto gestures = random_gestures(17, 20);
  const HandScriptOptions options;
  const auto script = script_hand(gestures, {}, options);
  ASSERT_GT(script.size(), 1000u);
  for (std::size_t i = 0; i < script.size(); ++i) {
    ASSERT_EQ(script[i].time_ns, static_cast<std::int64_t>(i) * 1'000'000);
    ASSERT_TRUE(is_finite(script[i].target_mm));
    if (i == 0 || script[i].target_mm.z < 0.0) continue;
    ASSERT_LT(norm(script[i].target_mm - script[i - 1].target_mm), 0.6);  // mm/ms
  }
}

// Returns the time from the first aim that moves along the line to the last one.
double drawing_time_s(const RecordedPath& line) {
  std::int64_t first_ns = -1, last_ns = 0;
  const auto script = script_hand(std::vector<RecordedPath>{line}, {});
  for (std::size_t i = 1; i < script.size(); ++i) {
    const Vec3 step = script[i].target_mm - script[i - 1].target_mm;
    if (std::fabs(step.x) < 1e-3 || script[i].target_mm.z > 0.0) continue;
    if (first_ns < 0) first_ns = script[i].time_ns;
    last_ns = script[i].time_ns;
  }
  return 1e-9 * static_cast<double>(last_ns - first_ns);
}

TEST(HandScript, GivesStrokesWithoutTimesAPace) {
  RecordedPath line;  // 50 mm long: takes at most a second, but is slower than 500 mm/s
  for (int i = 0; i <= 50; ++i) line.push_back({{10.0 + i, 20.0}, 0.5, std::nullopt});
  const double unhurried_s = drawing_time_s(line);
  EXPECT_GT(unhurried_s, 0.25);
  EXPECT_LT(unhurried_s, 1.5);
  RecordedPath stuck = line, backwards = line, slow = line;
  for (std::size_t i = 0; i < line.size(); ++i) {
    stuck[i].time_ns = 77;
    backwards[i].time_ns = -static_cast<std::int64_t>(i);
    slow[i].time_ns = static_cast<std::int64_t>(i) * 60'000'000;
  }
  EXPECT_NEAR(drawing_time_s(stuck), unhurried_s, 1e-9);
  EXPECT_NEAR(drawing_time_s(backwards), unhurried_s, 1e-9);
  EXPECT_NEAR(drawing_time_s(slow), 3.0, 0.1) << "its own times otherwise";
}

TEST(HandScript, SurvivesHostileRecordings) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::int64_t smallest = std::numeric_limits<std::int64_t>::min();
  const std::int64_t largest = std::numeric_limits<std::int64_t>::max();
  const std::vector<RecordedPath> paths{
      {},
      {{{nan, 1}, 0.5, 0}},
      {{{1, 1}, nan, smallest}, {{2, 1}, 1e9, largest}},
      {{{1, 1}, -3.0, 0}, {{nan, nan}, 0.5, 1}, {{1e300, 0}, 0.5, 2}, {{4, 1}, 0.5, 3}},
  };
  for (const TimedAim& aim : script_hand(paths, {})) ASSERT_TRUE(is_finite(aim.target_mm));
  EXPECT_TRUE(script_hand(std::vector<RecordedPath>{}, {}).empty());
  EXPECT_TRUE(script_hand(std::vector<RecordedPath>(3), {}).empty());
}

}  // namespace
}  // namespace felt::scripted_hand_test
